package arcomat.pipeline.campaign.joint;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.pipeline.compile.FieldForm;

/** A value of a model as the fields and constructors of generated monitors take it. */
public record FieldValue(Type type) implements FieldForm {
    /** Neither what is read in a world nor what is written as an argument is one. */
    @Override
    public Object objectValue(Value.ObjectValue value) {
        throw new IllegalArgumentException("an object: " + value);
    }

    /** The object that a constructor takes, from its text. */
    static Object read(String text, Class<?> parameter) {
        return switch (parameter.getName()) {
            case "boolean" -> Boolean.valueOf(text);
            case "byte" -> Byte.valueOf(text);
            case "short" -> Short.valueOf(text);
            case "int" -> Integer.valueOf(text);
            case "long" -> Long.valueOf(text);
            case "float" -> Float.valueOf(text);
            case "double" -> Double.valueOf(text);
            case "char" -> text.charAt(0);
            default -> text;
        };
    }
}
