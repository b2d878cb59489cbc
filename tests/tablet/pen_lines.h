/* What the pen of a test does, in lines of text that come through a named pipe:

     near 1 | near 0                   comes near, leaves
     move X Y PRESSURE TILT_X TILT_Y   pixels of the screen, 0 to 1, degrees
     tip 1 | tip 0                     presses, lifts
     button N 1 | button N 0           presses, lifts: 2 is the lower one, 3 the upper one
*/
#ifndef PASTOSO_TESTS_TABLET_PEN_LINES_H
#define PASTOSO_TESTS_TABLET_PEN_LINES_H

#include <stdbool.h>
#include <stddef.h>

enum pen_verb { kPenNear, kPenMove, kPenTip, kPenButton };

enum { kPenX, kPenY, kPenPressure, kPenTiltX, kPenTiltY, kPenValues };

struct pen_line {
    enum pen_verb verb;
    int on;                   /* 1 or 0, of all but kPenMove */
    int button;               /* 2 or 3, of kPenButton */
    double value[kPenValues]; /* of kPenMove */
};

enum { kPenMostText = 8192 };

struct pen_pipe {
    int fd;
    char text[kPenMostText]; /* read, of which no line has ended yet */
    size_t length;
};

/* Makes the pipe and opens it for reading without waiting. False where there can be none: `fd` is -1. */
bool pen_pipe_open(struct pen_pipe* pipe, const char* path);

void pen_pipe_close(struct pen_pipe* pipe);

/* Hands on, in their order, the lines that have come since. What is no such line is left out. */
void pen_pipe_read(struct pen_pipe* pipe, void (*obey)(void* pen, const struct pen_line* line),
                   void* pen);

#endif
