package arcomat.report.text;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;

/** JSON text with a line break at its end. */
public final class Json {
    private Json() {}

    /** Writes one value. */
    public interface Body {
        void write(JsonGenerator json) throws IOException;
    }

    /** With two blanks of indentation. */
    public static String text(Body body) {
        return compact(
                json -> {
                    json.setPrettyPrinter(printer());
                    body.write(json);
                });
    }

    private static DefaultPrettyPrinter printer() {
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        return new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter);
    }

    /** A text that is taken away while it grows; with two blanks of indentation. */
    public static final class Growing {
        private final StringWriter out = new StringWriter();
        private final JsonGenerator json;

        public Growing() {
            try {
                json = new JsonFactory().createGenerator(out);
                json.setPrettyPrinter(printer());
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /** What has come to the text, half a value perhaps, but a whole text. */
        public String add(Body part) {
            try {
                part.write(json);
                json.flush();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            String added = escapeHalfPairs(out.toString());
            out.getBuffer().setLength(0);
            return added;
        }
    }

    /** With no more blanks and line breaks than the body writes. */
    public static String compact(Body body) {
        StringWriter out = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(out)) {
            body.write(json);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return escapeHalfPairs(out.append('\n').toString());
    }

    /** A field with a list of texts. */
    public static void strings(JsonGenerator json, String field, List<String> all)
            throws IOException {
        json.writeArrayFieldStart(field);
        for (String each : all) {
            json.writeString(each);
        }
        json.writeEndArray();
    }

    /** Half of a surrogate pair, which models may send, has no encoding but an escape. */
    private static String escapeHalfPairs(String json) {
        if (json.codePoints().noneMatch(Json::isHalfPair)) {
            return json;
        }
        StringBuilder escaped = new StringBuilder();
        json.codePoints()
                .forEach(
                        c -> {
                            if (isHalfPair(c)) {
                                escaped.append(String.format("\\u%04x", c));
                            } else {
                                escaped.appendCodePoint(c);
                            }
                        });
        return escaped.toString();
    }

    private static boolean isHalfPair(int codePoint) {
        return Character.getType(codePoint) == Character.SURROGATE;
    }
}
