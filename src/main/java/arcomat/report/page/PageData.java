package arcomat.report.page;

import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.cfg.EnumFeature;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.StdSerializer;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a page tells, as JSON that may stand inside an HTML page: nothing in it begins a tag. Its
 * reader is {@code resources/report}; other programs have the formats of {@code arcomat.report}.
 */
record PageData(List<Story> stories) {
    /** A remark; its place with the lines that it covers. */
    private record Note(
            Page.Tone tone,
            String text,
            Optional<Integer> at,
            Optional<String> place,
            Optional<List<Excerpt.Line>> lines) {
        static Note of(Story.Remark remark) {
            Optional<Excerpt> excerpt = remark.place().map(Excerpt::of);
            return new Note(
                    remark.tone(),
                    remark.text(),
                    remark.at().stream().boxed().findFirst(),
                    excerpt.map(Excerpt::place),
                    excerpt.map(Excerpt::lines));
        }
    }

    /**
     * A track.
     *
     * @param elements of drawings, for each value, where there are any
     * @param runs value and length of each, one after the other
     */
    private record Row(
            String group,
            String name,
            Track.Kind kind,
            String before,
            List<String> values,
            Optional<List<List<String>>> elements,
            List<Integer> runs) {
        static Row of(Track track) {
            List<List<String>> elements =
                    track.values().stream().map(Track.Entry::elements).toList();
            return new Row(
                    track.group(),
                    track.name(),
                    track.kind(),
                    track.before(),
                    track.values().stream().map(Track.Entry::text).toList(),
                    Optional.of(elements).filter(all -> !all.stream().allMatch(List::isEmpty)),
                    track.runs().stream()
                            .flatMap(run -> Stream.of(run.value(), run.length()))
                            .toList());
        }
    }

    /** A drawing, with the number of its picture. */
    private record Picture(
            String title,
            int picture,
            List<String> tracks,
            Optional<Map<String, String>> carried) {}

    static String render(Page page) {
        Map<String, Integer> pictures = pictures(page);
        try {
            return Json.mapper()
                    .enable(JsonWriteFeature.ESCAPE_NON_ASCII)
                    .enable(EnumFeature.WRITE_ENUMS_TO_LOWERCASE)
                    .addModule(new SimpleModule().addSerializer(new TextSerializer()))
                    .addModule(Json.form(Story.Remark.class, Note::of))
                    .addModule(Json.form(Track.class, Row::of))
                    .addModule(
                            Json.form(
                                    Story.Drawing.class,
                                    each ->
                                            new Picture(
                                                    each.title(),
                                                    Objects.requireNonNull(
                                                            pictures.get(each.svg())),
                                                    each.tracks(),
                                                    Optional.of(each.carried())
                                                            .filter(all -> !all.isEmpty()))))
                    .build()
                    .writer(new HtmlEscapes())
                    .writeValueAsString(new PageData(page.stories()));
        } catch (JsonProcessingException e) {
            throw new AssertionError("texts and numbers can be written", e);
        }
    }

    /** Pictures by their SVG, numbered from 0: tests of one component share its picture. */
    static Map<String, Integer> pictures(Page page) {
        Map<String, Integer> pictures = new LinkedHashMap<>();
        for (Story story : page.stories()) {
            for (Story.Drawing drawing : story.drawings()) {
                pictures.putIfAbsent(drawing.svg(), pictures.size());
            }
        }
        return pictures;
    }

    /** What models say is made safe to show. */
    private static final class TextSerializer extends StdSerializer<String> {
        private static final long serialVersionUID = 1L;

        TextSerializer() {
            super(String.class);
        }

        @Override
        public void serialize(String text, JsonGenerator json, SerializerProvider provider)
                throws IOException {
            json.writeString(Printable.escape(text));
        }
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
            throw new AssertionError("standard escapes have no sequence of their own");
        }
    }
}
