// Turns a brush across its path, for a mouse and for pens that do not tell how they are turned.
#pragma once

namespace pastoso::tools {

/// Follows the pointer, touching or not, and tells how a flat tip stands across the way it came. Only
/// the axis of the movement counts: there and back again leaves the brush as it is.
class Heading {
  public:
    void moved_to(double x_mm, double y_mm);

    /// Forgets where it came from: the tip stands across a movement of that direction.
    void stand_across(double dx_mm, double dy_mm);

    /// Direction of the tip's width, clockwise on the canvas, -180 to 180; 0 before the first movement.
    /// Turns on past a right angle instead of jumping to the equal direction on the other side.
    double rotation_deg() const { return rotation_deg_; }

  private:
    void turn_to_axis();

    bool started_ = false;
    double x_mm_ = 0.0, y_mm_ = 0.0;
    // The axis as a vector of twice its angle, which makes opposite directions the same.
    double axis_x_ = -1.0, axis_y_ = 0.0;
    double rotation_deg_ = 0.0;
};

}  // namespace pastoso::tools
