package arcomat.generate;

import arcomat.generate.language.Escapes;
import arcomat.generate.language.Language;
import arcomat.generate.language.Names;
import arcomat.generate.language.References;
import arcomat.generate.language.Text;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Writes values as literals of the target's language. */
final class Literals {
    private final Names names;
    private final Language language;
    private final References references;

    Literals(Names names, References references) {
        this.names = names;
        this.language = names.language();
        this.references = references;
    }

    Text of(Value value, Type type) {
        if (value instanceof Value.BooleanValue truth) {
            return language.express("literal." + truth.value(), type, Map.of(), List.of());
        }
        if (value instanceof Value.IntegerValue integer) {
            return of(integer.value(), type);
        }
        if (value instanceof Value.RealValue real && !Double.isFinite(real.value())) {
            return quotient(real.value(), type);
        }
        if (value instanceof Value.RealValue real) {
            String digits = single(type) ? String.valueOf((float) real.value()) : real.toString();
            return number(digits.startsWith("-"), digits, type);
        }
        if (value instanceof Value.EnumValue constant) {
            return language.express(
                    "literal",
                    type,
                    Map.of(
                            "type", references.to(names.of(constant.type())),
                            "code", names.constant(constant.type(), constant.ordinal()).code(),
                            "number", String.valueOf(constant.ordinal() + 1)),
                    List.of());
        }
        if (value instanceof Value.ObjectValue object) {
            return object(object);
        }
        String content =
                value instanceof Value.CharacterValue c
                        ? Escapes.character(language, c.value())
                        : Escapes.string(language, ((Value.StringValue) value).value());
        return language.express("literal", type, Map.of("value", content), List.of());
    }

    /** What is infinite or no number has no literal. */
    private Text quotient(double value, Type type) {
        double dividend = Double.isNaN(value) ? 0 : Math.signum(value);
        List<Text> operands =
                List.of(of(new Value.RealValue(dividend), type), of(new Value.RealValue(0), type));
        return language.express("divide", type, Map.of(), operands);
    }

    Text of(long value, Type type) {
        return number(value < 0, String.valueOf(value), type);
    }

    private Text number(boolean negative, String digits, Type type) {
        String key = negative ? "literal.negative" : "literal";
        return language.express(key, type, Map.of("value", digits), List.of());
    }

    private static boolean single(Type type) {
        return type instanceof Type.RealType real && real.single();
    }

    private Text object(Value.ObjectValue object) {
        List<String> arguments = new ArrayList<>();
        for (int i = 0; i < object.attributes().size(); i++) {
            Type type = object.type().attributes().get(i).type();
            arguments.add(of(object.attributes().get(i), type).text());
        }
        Map<String, String> filled =
                Map.of(
                        "type", references.to(names.of(object.type())),
                        "arguments", String.join(", ", arguments));
        return language.express("literal", object.type(), filled, List.of());
    }

    String string(String content) {
        String escaped = Escapes.string(language, content);
        return language.express(
                        "literal", new Type.StringType(), Map.of("value", escaped), List.of())
                .text();
    }
}
