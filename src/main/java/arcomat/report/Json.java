package arcomat.report;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;

/** JSON text with two blanks of indentation and a line break at its end. */
final class Json {
    private Json() {}

    /** Writes one value. */
    interface Body {
        void write(JsonGenerator json) throws IOException;
    }

    static String text(Body body) {
        StringWriter out = new StringWriter();
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        DefaultPrettyPrinter printer =
                new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter);
        try (JsonGenerator json = new JsonFactory().createGenerator(out)) {
            json.setPrettyPrinter(printer);
            body.write(json);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return escapeHalfPairs(out.append('\n').toString());
    }

    /** A field with a list of texts. */
    static void strings(JsonGenerator json, String field, List<String> all) throws IOException {
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
