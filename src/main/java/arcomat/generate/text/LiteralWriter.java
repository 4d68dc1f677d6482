package arcomat.generate.text;

import arcomat.generate.language.Escapes;
import arcomat.generate.language.FileReferences;
import arcomat.generate.language.TargetLanguage;
import arcomat.generate.language.TargetNames;
import arcomat.generate.language.Text;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Writes types and values in the target's language, as one file names them. */
public final class LiteralWriter {
    private final TargetNames names;
    private final TargetLanguage language;
    private final FileReferences references;

    public LiteralWriter(TargetNames names, FileReferences references) {
        this.names = names;
        this.language = names.language();
        this.references = references;
    }

    /** How the file names a type that has a name of its own; empty for others. */
    String reference(Type type) {
        if (language.namesJava(type)) {
            return java(((Type.ClassType) type).java().orElseThrow());
        }
        boolean named = type instanceof Type.EnumType || type instanceof Type.ClassType;
        return named ? references.to(names.of(type)) : "";
    }

    /** With full names, so that nothing has to be imported. */
    private String java(Type.JavaClass java) {
        return java.arguments().isEmpty()
                ? java.name()
                : java.arguments().stream()
                        .map(each -> each.words() + each.type().map(this::object).orElse(""))
                        .collect(Collectors.joining(", ", java.name() + "<", ">"));
    }

    /** The name of the class that holds values of a type as objects. */
    private String object(Type type) {
        boolean named = type instanceof Type.EnumType || type instanceof Type.ClassType;
        String name =
                language.namesJava(type)
                        ? reference(type)
                        : named ? names.of(type).qualified() : "";
        return language.express("object", type, Map.of("type", name)).text();
    }

    /** The name of a type. */
    public String type(Type type) {
        return language.express("type", type, Map.of("type", reference(type))).text();
    }

    Text of(Value value, Type type) {
        return value.match(new Literal(type));
    }

    /** A string literal. */
    String string(String content) {
        return of(new Value.StringValue(content), new Type.StringType()).text();
    }

    private final class Literal implements Value.Cases<Text> {
        private final Type type;

        Literal(Type type) {
            this.type = type;
        }

        private Text literal(String content) {
            return language.express("literal", type, Map.of("value", content));
        }

        @Override
        public Text booleanValue(Value.BooleanValue truth) {
            return language.express("literal." + truth.value(), type, Map.of());
        }

        @Override
        public Text integerValue(Value.IntegerValue integer) {
            return number(String.valueOf(integer.value()));
        }

        /** What is infinite or no number has no literal: it is a quotient. */
        @Override
        public Text realValue(Value.RealValue real) {
            double value = real.value();
            if (!Double.isFinite(value)) {
                double dividend = Double.isNaN(value) ? 0 : Math.signum(value);
                return language.express(
                        "divide",
                        type,
                        Map.of(),
                        realValue(new Value.RealValue(dividend)),
                        realValue(new Value.RealValue(0)));
            }
            boolean single = type instanceof Type.RealType width && width.single();
            return number(single ? String.valueOf((float) value) : real.toString());
        }

        private Text number(String digits) {
            return digits.startsWith("-")
                    ? language.express("literal.negative", type, Map.of("value", digits))
                    : literal(digits);
        }

        @Override
        public Text characterValue(Value.CharacterValue character) {
            return literal(Escapes.character(language, character.value()));
        }

        @Override
        public Text stringValue(Value.StringValue string) {
            return literal(Escapes.string(language, string.value()));
        }

        @Override
        public Text enumValue(Value.EnumValue constant) {
            return language.express(
                    "literal",
                    type,
                    Map.of(
                            "type", reference(constant.type()),
                            "code", names.constant(constant.type(), constant.ordinal()).code(),
                            "number", String.valueOf(constant.ordinal() + 1)));
        }

        @Override
        public Text objectValue(Value.ObjectValue object) {
            List<String> arguments = new ArrayList<>();
            for (Type.Attribute attribute : object.type().attributes()) {
                Value value = object.attributes().get(arguments.size());
                arguments.add(of(value, attribute.type()).text());
            }
            return language.express(
                    "literal",
                    object.type(),
                    Map.of(
                            "type", reference(object.type()),
                            "arguments", String.join(", ", arguments)));
        }
    }
}
