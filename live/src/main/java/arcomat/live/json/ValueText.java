package arcomat.live.json;

import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Writes values that others have laid down as maps and lists of texts, numbers and truths. */
public final class ValueText {
    private final StringBuilder text = new StringBuilder();

    private ValueText() {}

    public static String of(Object value) {
        ValueText json = new ValueText();
        json.value(value);
        return json.text.toString();
    }

    private void value(Object value) {
        if (value instanceof Map<?, ?> fields) {
            object(fields);
        } else if (value instanceof List<?> all) {
            array(all.iterator());
        } else if (value instanceof Iterator<?> all) {
            array(all);
        } else if (value instanceof Number || value instanceof Boolean) {
            text.append(value);
        } else {
            text.append(JsonText.quoted(String.valueOf(value)));
        }
    }

    private void object(Map<?, ?> fields) {
        text.append('{');
        String before = "";
        for (Map.Entry<?, ?> field : fields.entrySet()) {
            text.append(before).append(JsonText.quoted(String.valueOf(field.getKey()))).append(':');
            value(field.getValue());
            before = ",";
        }
        text.append('}');
    }

    private void array(Iterator<?> all) {
        text.append('[');
        while (all.hasNext()) {
            value(all.next());
            text.append(all.hasNext() ? "," : "");
        }
        text.append(']');
    }
}
