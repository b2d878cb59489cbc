/* An input driver of the X server: a pen, or the eraser end of one, that is moved by lines of text from
   the named pipe of its option "Path":

     near 1 | near 0                   comes near, leaves
     move X Y PRESSURE TILT_X TILT_Y   pixels of the screen, 0 to 1, degrees
     tip 1 | tip 0                     presses, lifts
*/
#include <exevents.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xf86.h>
#include <xf86Xinput.h>
#include <xorg-server.h>
#include <xserver-properties.h>

enum { kAxes = 5, kButtons = 1, kMostText = 8192 };

struct axis {
    const char* label;
    int low, high;
    double unit; /* of the driver in one of the pipe's */
};

static const struct axis kAxis[kAxes] = {
    {AXIS_LABEL_PROP_ABS_X, 0, 160000, 100.0},         {AXIS_LABEL_PROP_ABS_Y, 0, 120000, 100.0},
    {AXIS_LABEL_PROP_ABS_PRESSURE, 0, 65535, 65535.0}, {AXIS_LABEL_PROP_ABS_TILT_X, -64, 63, 1.0},
    {AXIS_LABEL_PROP_ABS_TILT_Y, -64, 63, 1.0},
};

struct pen {
    char text[kMostText]; /* read, of which no line has ended yet */
    size_t length;
    ValuatorMask* values;
};

static void ignore_feedback(DeviceIntPtr device, PtrCtrl* control) {
    (void)device;
    (void)control;
}

static int make_device(DeviceIntPtr device) {
    Atom labels[kAxes], button_label[kButtons];
    unsigned char buttons[kButtons + 1] = {0, 1};
    for (int i = 0; i < kAxes; ++i)
        labels[i] = XIGetKnownProperty(kAxis[i].label);
    button_label[0] = XIGetKnownProperty(BTN_LABEL_PROP_BTN_LEFT);
    if (!InitButtonClassDeviceStruct(device, kButtons, button_label, buttons) ||
        !InitValuatorClassDeviceStruct(device, kAxes, labels, GetMotionHistorySize(), Absolute) ||
        !InitProximityClassDeviceStruct(device) ||
        !InitPtrFeedbackClassDeviceStruct(device, ignore_feedback))
        return BadAlloc;
    for (int i = 0; i < kAxes; ++i)
        InitValuatorAxisStruct(device, i, labels[i], kAxis[i].low, kAxis[i].high, 1000, 0, 1000,
                               Absolute);
    return Success;
}

static int control(DeviceIntPtr device, int what) {
    InputInfoPtr info = device->public.devicePrivate;
    switch (what) {
        case DEVICE_INIT:
            return make_device(device);
        case DEVICE_ON:
            xf86AddEnabledDevice(info);
            device->public.on = TRUE;
            return Success;
        case DEVICE_OFF:
            xf86RemoveEnabledDevice(info);
            device->public.on = FALSE;
            return Success;
        case DEVICE_CLOSE:
            return Success;
        default:
            return BadValue;
    }
}

static void obey(InputInfoPtr info, const char* line) {
    struct pen* pen = info->private;
    double value[kAxes];
    int on = 0;
    valuator_mask_zero(pen->values);
    if (sscanf(line, "move %lf %lf %lf %lf %lf", &value[0], &value[1], &value[2], &value[3],
               &value[4]) == kAxes) {
        for (int i = 0; i < kAxes; ++i)
            valuator_mask_set_double(pen->values, i, kAxis[i].unit * value[i]);
        xf86PostMotionEventM(info->dev, Absolute, pen->values);
    } else if (sscanf(line, "tip %d", &on) == 1) {
        xf86PostButtonEventM(info->dev, Absolute, 1, on, pen->values);
    } else if (sscanf(line, "near %d", &on) == 1) {
        xf86PostProximityEventM(info->dev, on, pen->values);
    }
}

static void read_lines(InputInfoPtr info) {
    struct pen* pen = info->private;
    ssize_t count;
    while ((count = read(info->fd, pen->text + pen->length, kMostText - pen->length)) > 0) {
        pen->length += (size_t)count;
        char* line = pen->text;
        char* end;
        while ((end = memchr(line, '\n', pen->length - (size_t)(line - pen->text))) != NULL) {
            *end = '\0';
            obey(info, line);
            line = end + 1;
        }
        pen->length -= (size_t)(line - pen->text);
        memmove(pen->text, line, pen->length);
    }
}

static int accept_mode(ClientPtr client, DeviceIntPtr device, int mode) {
    (void)client;
    (void)device;
    return mode == Absolute ? Success : BadMatch;
}

static int begin(InputDriverPtr driver, InputInfoPtr info, int flags) {
    (void)driver;
    (void)flags;
    char* path = xf86SetStrOption(info->options, "Path", NULL);
    struct pen* pen = calloc(1, sizeof *pen);
    if (path == NULL || pen == NULL) return BadAlloc;
    pen->values = valuator_mask_new(kAxes);
    info->private = pen;
    info->type_name = XI_TABLET;
    info->device_control = control;
    info->read_input = read_lines;
    info->switch_mode = accept_mode;
    /* Open for writing too: it has not ended when whoever writes to it closes it. */
    info->fd = mkfifo(path, 0600) == 0 ? open(path, O_RDWR | O_NONBLOCK) : -1;
    free(path);
    return info->fd < 0 ? BadAlloc : Success;
}

static void end(InputDriverPtr driver, InputInfoPtr info, int flags) {
    (void)driver;
    struct pen* pen = info->private;
    if (info->fd >= 0) close(info->fd);
    if (pen != NULL) valuator_mask_free(&pen->values);
    free(pen);
    info->private = NULL;
    xf86DeleteInput(info, flags);
}

static InputDriverRec kDriver = {
    .driverVersion = 1, .driverName = "tablet", .PreInit = begin, .UnInit = end};

static void* set_up(void* module, void* options, int* major, int* minor) {
    (void)options;
    (void)major;
    (void)minor;
    xf86AddInputDriver(&kDriver, module, 0);
    return module;
}

static XF86ModuleVersionInfo kVersion = {
    "tablet", MODULEVENDORSTRING, MODINFOSTRING1,     MODINFOSTRING2,   XORG_VERSION_CURRENT, 1, 0,
    0,        ABI_CLASS_XINPUT,   ABI_XINPUT_VERSION, MOD_CLASS_XINPUT, {0, 0, 0, 0}};

_X_EXPORT XF86ModuleData tabletModuleData = {&kVersion, set_up, NULL};
