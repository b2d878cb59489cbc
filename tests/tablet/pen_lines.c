#include "pen_lines.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Open for writing too: it has not ended when whoever writes to it closes it. */
bool pen_pipe_open(struct pen_pipe* pipe, const char* path) {
    pipe->length = 0;
    pipe->fd = mkfifo(path, 0600) == 0 ? open(path, O_RDWR | O_NONBLOCK | O_CLOEXEC) : -1;
    return pipe->fd >= 0;
}

void pen_pipe_close(struct pen_pipe* pipe) {
    if (pipe->fd >= 0) close(pipe->fd);
    pipe->fd = -1;
}

static bool parse(const char* text, struct pen_line* line) {
    double* value = line->value;
    if (sscanf(text, "move %lf %lf %lf %lf %lf", &value[kPenX], &value[kPenY], &value[kPenPressure],
               &value[kPenTiltX], &value[kPenTiltY]) == kPenValues)
        line->verb = kPenMove;
    else if (sscanf(text, "near %d", &line->on) == 1)
        line->verb = kPenNear;
    else if (sscanf(text, "tip %d", &line->on) == 1)
        line->verb = kPenTip;
    else if (sscanf(text, "button %d %d", &line->button, &line->on) == 2)
        line->verb = kPenButton;
    else
        return false;
    return true;
}

void pen_pipe_read(struct pen_pipe* pipe, void (*obey)(void* pen, const struct pen_line* line),
                   void* pen) {
    ssize_t count;
    while ((count = read(pipe->fd, pipe->text + pipe->length, kPenMostText - pipe->length)) > 0) {
        pipe->length += (size_t)count;
        char* text = pipe->text;
        char* end;
        while ((end = memchr(text, '\n', pipe->length - (size_t)(text - pipe->text))) != NULL) {
            struct pen_line line = {0};
            *end = '\0';
            if (parse(text, &line)) obey(pen, &line);
            text = end + 1;
        }
        pipe->length -= (size_t)(text - pipe->text);
        memmove(pipe->text, text, pipe->length);
    }
}
