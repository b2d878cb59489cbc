/* An input driver of the X server: a pen, or the eraser end of one, that does what it reads
   (pen_lines.h) from the named pipe of its option "Path". */
#include "pen_lines.h"

#include <exevents.h>
#include <stdlib.h>
#include <xf86.h>
#include <xf86Xinput.h>
#include <xorg-server.h>
#include <xserver-properties.h>

enum { kAxes = kPenValues, kButtons = 3 };

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
    struct pen_pipe pipe;
    ValuatorMask* values;
};

static void ignore_feedback(DeviceIntPtr device, PtrCtrl* control) {
    (void)device;
    (void)control;
}

static int make_device(DeviceIntPtr device) {
    Atom labels[kAxes], button_labels[kButtons];
    unsigned char buttons[kButtons + 1] = {0, 1, 2, 3};
    for (int i = 0; i < kAxes; ++i)
        labels[i] = XIGetKnownProperty(kAxis[i].label);
    button_labels[0] = XIGetKnownProperty(BTN_LABEL_PROP_BTN_LEFT);
    button_labels[1] = XIGetKnownProperty(BTN_LABEL_PROP_BTN_MIDDLE);
    button_labels[2] = XIGetKnownProperty(BTN_LABEL_PROP_BTN_RIGHT);
    if (!InitButtonClassDeviceStruct(device, kButtons, button_labels, buttons) ||
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

static void obey(void* of, const struct pen_line* line) {
    InputInfoPtr info = of;
    struct pen* pen = info->private;
    valuator_mask_zero(pen->values);
    switch (line->verb) {
        case kPenNear:
            xf86PostProximityEventM(info->dev, line->on, pen->values);
            break;
        case kPenMove:
            for (int i = 0; i < kAxes; ++i)
                valuator_mask_set_double(pen->values, i, kAxis[i].unit * line->value[i]);
            xf86PostMotionEventM(info->dev, Absolute, pen->values);
            break;
        case kPenTip:
            xf86PostButtonEventM(info->dev, Absolute, 1, line->on, pen->values);
            break;
        case kPenButton:
            xf86PostButtonEventM(info->dev, Absolute, line->button, line->on, pen->values);
            break;
    }
}

static void read_lines(InputInfoPtr info) {
    struct pen* pen = info->private;
    pen_pipe_read(&pen->pipe, obey, info);
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
    const bool is_open = pen_pipe_open(&pen->pipe, path);
    info->fd = pen->pipe.fd;
    free(path);
    return is_open ? Success : BadAlloc;
}

static void end(InputDriverPtr driver, InputInfoPtr info, int flags) {
    (void)driver;
    struct pen* pen = info->private;
    if (pen != NULL) {
        pen_pipe_close(&pen->pipe);
        valuator_mask_free(&pen->values);
    }
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
