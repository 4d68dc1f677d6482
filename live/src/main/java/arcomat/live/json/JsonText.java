package arcomat.live.json;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Writes JSON piece by piece. The tool's own writer of JSON looks into records by reflection, which
 * a browser has none of.
 */
public final class JsonText {
    private final StringBuilder text = new StringBuilder();

    /** Whether a comma is due before what comes next. */
    private boolean behindValue;

    /** The text of one object. */
    public static String object(Fields fields) {
        JsonText json = new JsonText();
        json.braces('{', '}', () -> fields.run(json));
        return json.text.toString();
    }

    /** A text as a value. */
    static String quoted(String value) {
        JsonText json = new JsonText();
        json.string(value);
        return json.text.toString();
    }

    /** Fills what somebody has opened. */
    @FunctionalInterface
    public interface Fields {
        void run(JsonText json);
    }

    public JsonText field(String name, String value) {
        name(name);
        string(value);
        return this;
    }

    public JsonText field(String name, long value) {
        name(name);
        next().append(value);
        return this;
    }

    public JsonText field(String name, boolean value) {
        name(name);
        next().append(value);
        return this;
    }

    /** A value that others have laid down. */
    public JsonText value(String name, Object value) {
        name(name);
        next().append(ValueText.of(value));
        return this;
    }

    public JsonText field(String name, Fields fields) {
        name(name);
        braces('{', '}', () -> fields.run(this));
        return this;
    }

    /** A list of objects, each filled by the same hand. */
    public <T> JsonText objects(String name, List<T> all, BiConsumer<JsonText, T> fields) {
        name(name);
        braces(
                '[',
                ']',
                () -> all.forEach(each -> braces('{', '}', () -> fields.accept(this, each))));
        return this;
    }

    public JsonText strings(String name, List<String> all) {
        name(name);
        braces('[', ']', () -> all.forEach(this::string));
        return this;
    }

    private void braces(char open, char close, Runnable inside) {
        next().append(open);
        behindValue = false;
        inside.run();
        text.append(close);
        behindValue = true;
    }

    private void name(String name) {
        string(name);
        text.append(':');
        behindValue = false;
    }

    private StringBuilder next() {
        if (behindValue) {
            text.append(',');
        }
        behindValue = true;
        return text;
    }

    private void string(String value) {
        next().append('"');
        for (int i = 0; i < value.length(); i++) {
            character(value.charAt(i));
        }
        text.append('"');
    }

    private void character(char c) {
        if (c == '"' || c == '\\') {
            text.append('\\').append(c);
        } else if (c < ' ' || c == 0x2028 || c == 0x2029 || Character.isSurrogate(c)) {
            String digits = Integer.toHexString(c);
            text.append("\\u").append("0".repeat(4 - digits.length())).append(digits);
        } else {
            text.append(c);
        }
    }
}
