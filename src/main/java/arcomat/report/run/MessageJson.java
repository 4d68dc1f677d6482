package arcomat.report.run;

import arcomat.model.Letter;
import arcomat.model.Value;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Messages for programs: as in models, but for numbers and truth values. */
public final class MessageJson implements Value.Cases<Object> {
    private static final MessageJson FORMS = new MessageJson();

    private MessageJson() {}

    /** One message. */
    public static Object of(Value value) {
        return value.match(FORMS);
    }

    /** Several in an event. */
    public static List<Object> all(List<Value> values) {
        return values.stream().map(MessageJson::of).toList();
    }

    /** Lists of messages by ports. */
    static Map<String, List<Object>> all(Letter letter) {
        Map<String, List<Object>> messages = new LinkedHashMap<>();
        letter.messages().forEach((port, values) -> messages.put(port, all(values)));
        return messages;
    }

    @Override
    public Object booleanValue(Value.BooleanValue truth) {
        return truth.value();
    }

    @Override
    public Object integerValue(Value.IntegerValue number) {
        return number.value();
    }

    @Override
    public Object realValue(Value.RealValue number) {
        return Double.isFinite(number.value()) ? (Object) number.value() : number.toString();
    }

    @Override
    public Object characterValue(Value.CharacterValue character) {
        return character.toString();
    }

    @Override
    public Object stringValue(Value.StringValue string) {
        return string.value();
    }

    @Override
    public Object enumValue(Value.EnumValue constant) {
        return constant.toString();
    }

    @Override
    public Object objectValue(Value.ObjectValue object) {
        return object.toString();
    }
}
