package arcomat.agent.server;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonParseException;
import com.google.gson.Strictness;
import com.google.gson.TypeAdapter;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.JsonWriter;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.util.Optional;

/** JSON on one line. Numbers are kept as they are written. */
final class JsonText {
    private static final TypeAdapter<JsonElement> ANY = new Gson().getAdapter(JsonElement.class);

    private JsonText() {}

    /** Empty for what is no JSON. */
    static Optional<JsonElement> read(String line) {
        JsonReader reader = new JsonReader(new StringReader(line));
        reader.setStrictness(Strictness.STRICT);
        try {
            JsonElement read = ANY.read(reader);
            return Optional.of(read).filter(any -> isOver(reader));
        } catch (IOException | JsonParseException | IllegalStateException noJson) {
            return Optional.empty();
        }
    }

    private static boolean isOver(JsonReader reader) {
        try {
            return reader.peek() == JsonToken.END_DOCUMENT;
        } catch (IOException more) {
            return false;
        }
    }

    static String write(JsonElement json) throws IOException {
        StringWriter text = new StringWriter();
        JsonWriter writer = new JsonWriter(text);
        writer.setHtmlSafe(true);
        ANY.write(writer, json);
        return withBytes(text.toString());
    }

    /** Half of a pair of surrogates has no bytes in UTF-8, and stands in JSON by its number. */
    private static String withBytes(String line) {
        if (line.codePoints().noneMatch(JsonText::isHalf)) {
            return line;
        }
        StringBuilder text = new StringBuilder();
        line.codePoints()
                .forEach(
                        each -> {
                            if (isHalf(each)) {
                                text.append("\\u%04x".formatted(each));
                            } else {
                                text.appendCodePoint(each);
                            }
                        });
        return text.toString();
    }

    private static boolean isHalf(int codePoint) {
        return codePoint >= Character.MIN_SURROGATE && codePoint <= Character.MAX_SURROGATE;
    }
}
