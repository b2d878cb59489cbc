/* A module of Weston: a tablet with a pen of two ends, told to programs by the protocol of tablets,
   which Weston itself does not speak. Both ends do what they read (pen_lines.h) from the named pipes
   "pen" and "eraser", which the module makes in the folder $PASTOSO_TEST_TABLET. */
#include "pen_lines.h"
#include "tablet-unstable-v2-server-protocol.h"

#include <libweston/libweston.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* Of libweston, for those who make seats: its public headers leave them out. */
void weston_seat_init(struct weston_seat* seat, struct weston_compositor* compositor, const char* name);
void weston_seat_release(struct weston_seat* seat);

enum { kEnds = 2, kMostButtons = 2, kFullPressure = 65535 };

/* One end of the pen. Both have one serial number, as those of a real one. */
struct pen_end {
    struct tablet* tablet;
    const char* name;
    enum zwp_tablet_tool_v2_type type;
    struct pen_pipe pipe;
    struct wl_list resources;  /* of the programs that know it */
    struct weston_view* under; /* what hears it; null: nothing */
    struct wl_listener under_destroyed;
    bool is_near, is_down;
    bool is_pressed[kMostButtons];
};

struct tablet {
    struct weston_compositor* compositor;
    struct weston_seat seat;
    struct wl_list resources;
    struct pen_end ends[kEnds];
    struct wl_listener destroyed;
};

/* ---- what programs may ask */

static void forget(struct wl_resource* resource) {
    wl_list_remove(wl_resource_get_link(resource));
}

static void destroy(struct wl_client* client, struct wl_resource* resource) {
    (void)client;
    wl_resource_destroy(resource);
}

/* Nobody sees this screen. */
static void set_cursor(struct wl_client* client, struct wl_resource* resource, uint32_t serial,
                       struct wl_resource* surface, int32_t hot_x, int32_t hot_y) {
    (void)client, (void)resource, (void)serial, (void)surface, (void)hot_x, (void)hot_y;
}

static const struct zwp_tablet_tool_v2_interface kToolRequests = {.set_cursor = set_cursor,
                                                                  .destroy = destroy};
static const struct zwp_tablet_v2_interface kTabletRequests = {.destroy = destroy};
static const struct zwp_tablet_seat_v2_interface kSeatRequests = {.destroy = destroy};

/* A new object of the program that has `parent`, kept in `list`. */
static struct wl_resource* make(const struct wl_interface* interface, const void* requests,
                                struct wl_resource* parent, struct wl_list* list) {
    struct wl_client* client = wl_resource_get_client(parent);
    struct wl_resource* made = wl_resource_create(client, interface, wl_resource_get_version(parent), 0);
    if (made == NULL) {
        wl_client_post_no_memory(client);
        return NULL;
    }
    wl_resource_set_implementation(made, requests, NULL, forget);
    wl_list_insert(list, wl_resource_get_link(made));
    return made;
}

static void tell_tablet(struct tablet* tablet, struct wl_resource* seat) {
    struct wl_resource* told =
        make(&zwp_tablet_v2_interface, &kTabletRequests, seat, &tablet->resources);
    if (told == NULL) return;
    zwp_tablet_seat_v2_send_tablet_added(seat, told);
    zwp_tablet_v2_send_name(told, "Test Tablet");
    zwp_tablet_v2_send_done(told);
}

static void tell_end(struct pen_end* end, struct wl_resource* seat) {
    struct wl_resource* told =
        make(&zwp_tablet_tool_v2_interface, &kToolRequests, seat, &end->resources);
    if (told == NULL) return;
    zwp_tablet_seat_v2_send_tool_added(seat, told);
    zwp_tablet_tool_v2_send_type(told, end->type);
    zwp_tablet_tool_v2_send_hardware_serial(told, 0, 1);
    zwp_tablet_tool_v2_send_capability(told, ZWP_TABLET_TOOL_V2_CAPABILITY_PRESSURE);
    zwp_tablet_tool_v2_send_capability(told, ZWP_TABLET_TOOL_V2_CAPABILITY_TILT);
    zwp_tablet_tool_v2_send_done(told);
}

static void get_tablet_seat(struct wl_client* client, struct wl_resource* manager, uint32_t id,
                            struct wl_resource* of) {
    struct tablet* tablet = wl_resource_get_user_data(manager);
    struct wl_resource* seat =
        wl_resource_create(client, &zwp_tablet_seat_v2_interface, wl_resource_get_version(manager), id);
    if (seat == NULL) {
        wl_client_post_no_memory(client);
        return;
    }
    wl_resource_set_implementation(seat, &kSeatRequests, tablet, NULL);
    if (wl_resource_get_user_data(of) != &tablet->seat) return; /* another seat has no tablet */
    tell_tablet(tablet, seat);
    for (int i = 0; i < kEnds; ++i)
        tell_end(&tablet->ends[i], seat);
}

static const struct zwp_tablet_manager_v2_interface kManagerRequests = {
    .get_tablet_seat = get_tablet_seat, .destroy = destroy};

static void bind_manager(struct wl_client* client, void* tablet, uint32_t version, uint32_t id) {
    struct wl_resource* manager =
        wl_resource_create(client, &zwp_tablet_manager_v2_interface, (int)version, id);
    if (manager == NULL)
        wl_client_post_no_memory(client);
    else
        wl_resource_set_implementation(manager, &kManagerRequests, tablet, NULL);
}

/* ---- what they are told */

static uint32_t next_serial(const struct pen_end* end) {
    return wl_display_next_serial(end->tablet->compositor->wl_display);
}

/* The end, as the program knows it that has the surface below; null where none does. */
static struct wl_resource* hearer(struct pen_end* end) {
    if (end->under == NULL || end->under->surface->resource == NULL) return NULL;
    return wl_resource_find_for_client(&end->resources,
                                       wl_resource_get_client(end->under->surface->resource));
}

/* Ends what belongs together: one event of the device. */
static void send_frame(struct wl_resource* tool) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    zwp_tablet_tool_v2_send_frame(tool, (uint32_t)(now.tv_sec * 1000 + now.tv_nsec / 1000000));
}

static void send_button(struct pen_end* end, struct wl_resource* tool, int button) {
    static const uint32_t kCode[kMostButtons] = {BTN_STYLUS, BTN_STYLUS2};
    zwp_tablet_tool_v2_send_button(tool, next_serial(end), kCode[button], end->is_pressed[button]);
}

static void send_tip(struct pen_end* end, struct wl_resource* tool) {
    if (end->is_down)
        zwp_tablet_tool_v2_send_down(tool, next_serial(end));
    else
        zwp_tablet_tool_v2_send_up(tool);
}

static void forget_view(struct pen_end* end) {
    wl_list_remove(&end->under_destroyed.link);
    end->under = NULL;
}

static void lose_view(struct wl_listener* listener, void* view) {
    (void)view;
    struct pen_end* end = wl_container_of(listener, end, under_destroyed);
    forget_view(end);
}

static void enter(struct pen_end* end, struct weston_view* view) {
    end->under = view;
    end->under_destroyed.notify = lose_view;
    wl_signal_add(&view->destroy_signal, &end->under_destroyed);
    struct wl_resource* tool = hearer(end);
    if (tool == NULL) return;
    struct wl_resource* tablet =
        wl_resource_find_for_client(&end->tablet->resources, wl_resource_get_client(tool));
    zwp_tablet_tool_v2_send_proximity_in(tool, next_serial(end), tablet, view->surface->resource);
}

/* What is still pressed is let go within the same frame, as the protocol has it. */
static void leave(struct pen_end* end) {
    struct wl_resource* tool = hearer(end);
    const bool was_down = end->is_down;
    end->is_down = false;
    if (tool != NULL && was_down) send_tip(end, tool);
    for (int i = 0; i < kMostButtons; ++i) {
        const bool was_pressed = end->is_pressed[i];
        end->is_pressed[i] = false;
        if (tool != NULL && was_pressed) send_button(end, tool, i);
    }
    if (tool != NULL) {
        zwp_tablet_tool_v2_send_proximity_out(tool);
        send_frame(tool);
    }
    if (end->under != NULL) forget_view(end);
}

/* ---- what the pen does */

/* The surface on top hears the end, and goes on hearing it while the tip is down. */
static void move(struct pen_end* end, const double* value) {
    const wl_fixed_t x = wl_fixed_from_double(value[kPenX]), y = wl_fixed_from_double(value[kPenY]);
    wl_fixed_t view_x, view_y;
    if (!end->is_down) {
        struct weston_view* view =
            weston_compositor_pick_view(end->tablet->compositor, x, y, &view_x, &view_y);
        if (view != end->under && end->under != NULL) leave(end);
        if (view != end->under) enter(end, view);
    }
    struct wl_resource* tool = hearer(end);
    if (tool == NULL) return;
    weston_view_from_global_fixed(end->under, x, y, &view_x, &view_y);
    zwp_tablet_tool_v2_send_motion(tool, view_x, view_y);
    zwp_tablet_tool_v2_send_pressure(tool, (uint32_t)(kFullPressure * value[kPenPressure] + 0.5));
    zwp_tablet_tool_v2_send_tilt(tool, wl_fixed_from_double(value[kPenTiltX]),
                                 wl_fixed_from_double(value[kPenTiltY]));
    send_frame(tool);
}

static void press_tip(struct pen_end* end, bool on) {
    struct wl_resource* tool = hearer(end);
    end->is_down = on;
    if (tool == NULL) return;
    send_tip(end, tool);
    send_frame(tool);
}

static void press_button(struct pen_end* end, int button, bool on) {
    struct wl_resource* tool = hearer(end);
    if (button < 0 || button >= kMostButtons) return;
    end->is_pressed[button] = on;
    if (tool == NULL) return;
    send_button(end, tool, button);
    send_frame(tool);
}

static void obey(void* of, const struct pen_line* line) {
    struct pen_end* end = of;
    switch (line->verb) {
        case kPenNear:
            end->is_near = line->on != 0;
            if (!end->is_near) leave(end);
            break;
        case kPenMove:
            if (end->is_near) move(end, line->value);
            break;
        case kPenTip:
            if (end->is_near) press_tip(end, line->on != 0);
            break;
        case kPenButton:
            if (end->is_near) press_button(end, line->button - 2, line->on != 0);
            break;
    }
}

static int read_lines(int fd, uint32_t mask, void* end) {
    (void)fd, (void)mask;
    pen_pipe_read(&((struct pen_end*)end)->pipe, obey, end);
    return 0;
}

/* ---- the module */

static bool begin_end(struct pen_end* end, const char* folder) {
    char path[4096];
    wl_list_init(&end->resources);
    snprintf(path, sizeof path, "%s/%s", folder, end->name);
    if (!pen_pipe_open(&end->pipe, path)) return false;
    struct wl_event_loop* loop = wl_display_get_event_loop(end->tablet->compositor->wl_display);
    return wl_event_loop_add_fd(loop, end->pipe.fd, WL_EVENT_READABLE, read_lines, end) != NULL;
}

static void finish(struct wl_listener* listener, void* compositor) {
    (void)compositor;
    struct tablet* tablet = wl_container_of(listener, tablet, destroyed);
    weston_seat_release(&tablet->seat);
}

/* The seat first: programs ask for the tablets of those that they know. */
int wet_module_init(struct weston_compositor* compositor, int* argc, char* argv[]);
int wet_module_init(struct weston_compositor* compositor, int* argc, char* argv[]) {
    (void)argc, (void)argv;
    static struct tablet tablet;
    const char* folder = getenv("PASTOSO_TEST_TABLET");
    if (folder == NULL) return -1;
    tablet.compositor = compositor;
    wl_list_init(&tablet.resources);
    weston_seat_init(&tablet.seat, compositor, "tablet");
    tablet.ends[0] =
        (struct pen_end){.tablet = &tablet, .name = "pen", .type = ZWP_TABLET_TOOL_V2_TYPE_PEN};
    tablet.ends[1] =
        (struct pen_end){.tablet = &tablet, .name = "eraser", .type = ZWP_TABLET_TOOL_V2_TYPE_ERASER};
    for (int i = 0; i < kEnds; ++i)
        if (!begin_end(&tablet.ends[i], folder)) return -1;
    tablet.destroyed.notify = finish;
    wl_signal_add(&compositor->destroy_signal, &tablet.destroyed);
    return wl_global_create(compositor->wl_display, &zwp_tablet_manager_v2_interface, 1, &tablet,
                            bind_manager) == NULL
               ? -1
               : 0;
}
