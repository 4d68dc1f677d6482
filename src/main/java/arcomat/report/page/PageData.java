package arcomat.report.page;

import arcomat.report.text.Printable;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.io.SerializedString;
import com.fasterxml.jackson.core.json.JsonWriteFeature;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a page tells, as JSON that may stand inside an HTML page: nothing in it begins a tag. Its
 * reader is {@code resources/report}; other programs have the formats of {@code arcomat.report}.
 */
final class PageData {
    private final JsonGenerator json;

    /** Pictures by their SVG, numbered from 0: tests of one component share its picture. */
    private final Map<String, Integer> pictures;

    private PageData(JsonGenerator json, Map<String, Integer> pictures) {
        this.json = json;
        this.pictures = pictures;
    }

    static String render(Page page) {
        StringWriter out = new StringWriter();
        try (JsonGenerator json =
                JsonFactory.builder()
                        .enable(JsonWriteFeature.ESCAPE_NON_ASCII)
                        .build()
                        .createGenerator(out)) {
            json.setCharacterEscapes(new HtmlEscapes());
            new PageData(json, pictures(page)).write(page);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toString();
    }

    static Map<String, Integer> pictures(Page page) {
        Map<String, Integer> pictures = new LinkedHashMap<>();
        for (Story story : page.stories()) {
            for (Drawing drawing : story.drawings()) {
                pictures.putIfAbsent(drawing.svg(), pictures.size());
            }
        }
        return pictures;
    }

    private void write(Page page) throws IOException {
        json.writeStartObject();
        json.writeArrayFieldStart("stories");
        for (Story story : page.stories()) {
            write(story);
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private void write(Story story) throws IOException {
        Timeline timeline = story.timeline();
        json.writeStartObject();
        text("title", story.title());
        tone(story.tone());
        text("headline", story.headline());
        json.writeArrayFieldStart("remarks");
        for (Remark remark : story.remarks()) {
            write(remark);
        }
        json.writeEndArray();
        text("unit", timeline.unit());
        json.writeNumberField("length", timeline.length());
        json.writeArrayFieldStart("times");
        for (long time : timeline.times()) {
            json.writeNumber(time);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("tracks");
        for (Track track : timeline.tracks()) {
            write(track);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("flaws");
        for (Timeline.Flaw flaw : timeline.flaws()) {
            json.writeStartObject();
            json.writeNumberField("at", flaw.at());
            text("track", flaw.track());
            text("text", flaw.text());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeArrayFieldStart("drawings");
        for (Drawing drawing : story.drawings()) {
            json.writeStartObject();
            text("title", drawing.title());
            json.writeNumberField("picture", pictures.get(drawing.svg()));
            texts("tracks", drawing.tracks());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private void write(Track track) throws IOException {
        json.writeStartObject();
        text("group", track.group());
        text("name", track.name());
        json.writeStringField("kind", track.kind().name().toLowerCase(java.util.Locale.ROOT));
        text("before", track.before());
        json.writeArrayFieldStart("values");
        for (Track.Entry value : track.values()) {
            json.writeString(Printable.escape(value.text()));
        }
        json.writeEndArray();
        if (track.values().stream().anyMatch(value -> !value.elements().isEmpty())) {
            json.writeArrayFieldStart("elements");
            for (Track.Entry value : track.values()) {
                json.writeStartArray();
                for (String element : value.elements()) {
                    json.writeString(element);
                }
                json.writeEndArray();
            }
            json.writeEndArray();
        }
        json.writeArrayFieldStart("runs");
        for (Track.Run run : track.runs()) {
            json.writeNumber(run.value());
            json.writeNumber(run.length());
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private void write(Remark remark) throws IOException {
        json.writeStartObject();
        tone(remark.tone());
        text("text", remark.text());
        if (remark.at().isPresent()) {
            json.writeNumberField("at", remark.at().getAsInt());
        }
        if (remark.place().isPresent()) {
            write(remark.place().get());
        }
        json.writeEndObject();
    }

    /** The place with the lines that it covers. */
    private void write(Span place) throws IOException {
        Excerpt excerpt = Excerpt.of(place);
        json.writeStringField("place", Printable.escape(excerpt.place()));
        json.writeArrayFieldStart("lines");
        for (Excerpt.Line line : excerpt.lines()) {
            json.writeStartObject();
            json.writeNumberField("number", line.number());
            text("before", line.before());
            text("marked", line.marked());
            text("after", line.after());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private void tone(Tone tone) throws IOException {
        json.writeStringField("tone", tone.name().toLowerCase(java.util.Locale.ROOT));
    }

    private void text(String field, String text) throws IOException {
        json.writeStringField(field, Printable.escape(text));
    }

    private void texts(String field, List<String> texts) throws IOException {
        json.writeArrayFieldStart(field);
        for (String text : texts) {
            json.writeString(Printable.escape(text));
        }
        json.writeEndArray();
    }

    /** Neither {@code </script>} nor {@code <!--} can occur where no text has {@code <}. */
    private static final class HtmlEscapes extends CharacterEscapes {
        private static final long serialVersionUID = 1L;

        @Override
        public int[] getEscapeCodesForAscii() {
            int[] codes = standardAsciiEscapesForJSON();
            codes['<'] = ESCAPE_STANDARD;
            codes['>'] = ESCAPE_STANDARD;
            codes['&'] = ESCAPE_STANDARD;
            return codes;
        }

        @Override
        public SerializableString getEscapeSequence(int c) {
            return new SerializedString(String.format("\\u%04x", c));
        }
    }
}
