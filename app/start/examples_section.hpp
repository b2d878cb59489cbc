// The part of the start page that opens the paintings that come with the program.
#pragma once

#include "start/example_paintings.hpp"

#include <vector>

#include <QWidget>

namespace pastoso::panels {
class Gallery;
}

namespace pastoso::start {

class Gallery;

class ExamplesSection : public QWidget {
    Q_OBJECT
  public:
    explicit ExamplesSection(QWidget* parent = nullptr);

    void fit(int width);

    panels::Gallery* gallery() { return gallery_; }

  Q_SIGNALS:
    void wanted(const pastoso::start::ExamplePainting& example);

  private:
    const std::vector<ExamplePainting> examples_ = example_paintings();
    panels::Gallery* gallery_;
};

}  // namespace pastoso::start
