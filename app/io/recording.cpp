#include "app/io/recording.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>

#include "app/io/failure.h"
#include "app/io/frame_series.h"
#include "app/io/nearest.h"
#include "app/io/recording_sets.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr std::chrono::milliseconds kFirstFlush{100}, kFlushes{5000};

/// Integers where numbers only tell apart; points of large litters are many, so afferents are kept
/// in few bytes.
NumberType type_of(const LitterField& field) {
  if (!field.categories.empty()) return NumberType::u1;
  if (field.kind == FieldKind::categorical) return NumberType::i2;
  return field.of_afferents ? NumberType::f4 : NumberType::f8;
}

void add_once(std::vector<const LitterField*>& fields, const LitterField* field) {
  if (std::find(fields.begin(), fields.end(), field) == fields.end()) fields.push_back(field);
}

void add_table(std::span<const LitterField> table, std::vector<const LitterField*>& fields) {
  for (const LitterField& field : table) {
    if (field.in_recordings) add_once(fields, &field);
  }
}

[[noreturn]] void refuse_name(std::string_view name) {
  std::vector<std::string_view> names{"pup", "afferent", "point"};
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) names.push_back(field.name);
  }
  const std::string meant = did_you_mean(name, names);
  refuse("--record-fields: there is no field " + io::quoted(std::string(name)) +
         (meant.empty() ? "; name pup, afferent, point or fields of 'pupflow fields'" : meant));
}

}  // namespace

PartSet RecordedFields::parts() const {
  PartSet parts;
  for (const LitterField* field : fields) parts = parts | field->parts;
  return parts;
}

RecordedFields parse_recorded_fields(const std::string& names) {
  RecordedFields recorded;
  for (const std::string_view name : split(names, ',')) {
    if (name == "pup") {
      add_table(pup_fields(), recorded.fields);
    } else if (name == "afferent") {
      add_table(afferent_fields(), recorded.fields);
    } else if (name == "point") {
      recorded.positions = true;
    } else if (const LitterField* field = find_field(name)) {
      add_once(recorded.fields, field);
    } else {
      refuse_name(name);
    }
  }
  return recorded;
}

class Recording::File {
 public:
  File(const std::string& path, bool force, const Params& params, const TextEntries& about,
       const RecordedFields& recorded)
      : file(path, force, Hdf5Kind::recording), writer_(file) {
    file.about(about);
    file.text("kind", "recording");
    file.number(file.id(), "layout", std::int64_t{kRecordingLayout});
    pups_ = static_cast<hsize_t>(params.pups);
    points_ = static_cast<hsize_t>(points_per_pup(params));
    write_skin(file, params.face_points);
    make_frames();
    if (pups_ > 0) {
      make_fields(recorded.fields, false);
      make_fields(recorded.fields, true);
      if (recorded.positions) make_positions(params.precision);
    }
    file.only_grow();
  }

  void add(const LitterView& litter) {
    const std::int64_t frame = frames_++;
    for (const Set& set : sets_) {
      set.fill(litter, frame, *set.series);
      set.series->next_frame();
    }
    if (Time::now() >= next_flush_) flush();
  }

  void finish() {
    for (const Set& set : sets_) set.series->finish();
    sets_.clear();
    frame_ = nullptr;
  }

  Hdf5Writer file;

 private:
  using Time = std::chrono::steady_clock;

  /// What is recorded gets to the file after kFirstFlush, after twice that time, and so on, then
  /// every kFlushes.
  void flush() {
    for (const Set& set : sets_) set.series->flush();
    writer_.thread.run([this] { file.flush(); });
    const Time::time_point now = Time::now();
    next_flush_ = now + std::min<Time::duration>(now - start_, kFlushes);
  }

  using Fill = std::function<void(const LitterView&, std::int64_t frame, FrameSeries&)>;
  struct Set {
    std::unique_ptr<FrameSeries> series;
    Fill fill;
  };

  FrameSeries& add_set(const std::string& name, const std::vector<hsize_t>& shape, NumberType type,
                       std::string_view units, std::string_view description, Fill fill) {
    sets_.push_back({std::make_unique<FrameSeries>(writer_, name, shape, type), std::move(fill)});
    FrameSeries& series = *sets_.back().series;
    describe(file, series.id(), units, description);
    if (frame_ != nullptr) attach_dimension(file, series.id(), frame_->id(), 0);
    return series;
  }

  void make_frames() {
    FrameSeries& frame = add_set(
        "frame", {}, NumberType::i8, "", "Number of the frame.",
        [](const LitterView&, std::int64_t number, FrameSeries& series) { put(series, number); });
    make_dimension(file, frame.id(), "frame");
    frame_ = &frame;
    add_set("time", {}, NumberType::f8, "s", "Time in the model.",
            [](const LitterView& litter, std::int64_t, FrameSeries& series) {
              put(series, litter.time);
            });
    add_set("step", {}, NumberType::i8, "", "Steps done.",
            [](const LitterView& litter, std::int64_t, FrameSeries& series) {
              put(series, litter.step);
            });
  }

  /// The groups pup or afferent, with the fields that belong there.
  void make_fields(const std::vector<const LitterField*>& fields, bool of_afferents) {
    const std::string group = of_afferents ? "afferent" : "pup";
    std::vector<hsize_t> shape{pups_};
    if (of_afferents) shape.push_back(points_);
    std::vector<Handle> dimensions;
    for (const LitterField* field : fields) {
      if (field->of_afferents != of_afferents) continue;
      if (dimensions.empty()) dimensions = dimensions_of(group, of_afferents ? "afferent" : "");
      const FrameSeries& series = add_set(
          group + "/" + std::string(field->name), shape, type_of(*field), field->unit, field->doc,
          [this, field](const LitterView& litter, std::int64_t, FrameSeries& to) {
            values_.resize(to.items() * (field->of_afferents ? points_ : 1));
            field->fill(litter, values_);
            to.fill(values_);
          });
      file.text(series.id(), "long_name", std::string(field->label));
      if (!field->categories.empty()) {
        file.text(series.id(), "categories", joined(field->categories, ","));
      }
      attach(series, dimensions);
    }
  }

  void make_positions(Precision precision) {
    std::vector<Handle> dimensions = dimensions_of("point", "point");
    dimensions.push_back(write_dimension(file, "point", "axis", 3, "x, y, z of the arena."));
    const bool single = precision == Precision::float_;
    const FrameSeries& series = add_set(
        "point/position", {pups_, points_, 3}, single ? NumberType::f4 : NumberType::f8, "length",
        "Positions of the points.", single ? put_positions<float> : put_positions<double>);
    attach(series, dimensions);
  }

  /// GROUP/pup, and GROUP/`second` where there is one.
  std::vector<Handle> dimensions_of(const std::string& group, const std::string& second) {
    std::vector<Handle> dimensions;
    dimensions.push_back(write_dimension(file, group, "pup", pups_, "Number of the pup."));
    if (second.empty()) return dimensions;
    dimensions.push_back(write_dimension(file, group, second, points_, "Point of a pup."));
    return dimensions;
  }

  void attach(const FrameSeries& series, const std::vector<Handle>& dimensions) const {
    for (unsigned i = 0; i < dimensions.size(); ++i) {
      attach_dimension(file, series.id(), dimensions[i], i + 1);
    }
  }

  template <class Number>
  static void put(FrameSeries& series, Number number) {
    std::memcpy(series.row(0).data(), &number, sizeof number);
  }

  template <class Real>
  static void put_positions(const LitterView& litter, std::int64_t, FrameSeries& series) {
    for (int pup = 0; pup < litter.pups; ++pup) {
      const std::span<std::byte> row = series.row(static_cast<std::size_t>(pup));
      litter.positions.copy_pup_to(
          pup, std::span(reinterpret_cast<Real*>(row.data()), row.size() / sizeof(Real)));
    }
  }

  hsize_t pups_ = 0, points_ = 0;
  std::int64_t frames_ = 0;
  Time::time_point start_ = Time::now(), next_flush_ = start_ + kFirstFlush;
  std::vector<double> values_;
  std::vector<Set> sets_;  // closed before the file is,
  FrameSeries* frame_ = nullptr;
  SeriesWriter writer_;  // and after its thread has ended
};

Recording::Recording(const std::string& path, bool force, const Params& params,
                     const TextEntries& about, const RecordedFields& fields)
    : file_(std::make_unique<File>(path, force, params, about, fields)) {}

Recording::~Recording() = default;

void Recording::add(const LitterView& litter) {
  file_->add(litter);
}

void Recording::note(const std::string& name, const std::string& value) {
  file_->finish();
  file_->file.text(name, value);
}

void Recording::commit(const std::string& ending) {
  file_->finish();
  if (!ending.empty()) file_->file.text("ended early", ending);
  file_->file.commit();
}

}  // namespace pupflow::io
