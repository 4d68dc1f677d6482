package arcomat.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** The type of a message, a variable or an expression. */
public sealed interface Type {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R booleanType(BooleanType booleanType);

        R integerType(IntegerType integerType);

        R realType(RealType realType);

        R characterType(CharacterType characterType);

        R stringType(StringType stringType);

        R enumType(EnumType enumType);

        R classType(ClassType classType);
    }

    /** The name as written in models; enums and classes by their qualified name. */
    String name();

    /**
     * Its first value: 0, false, the empty string, the first constant of an enumeration, the low
     * end of a range without 0. Variables start with it, and where a model leaves open which
     * message a total port carries, a run without random choices sends it.
     */
    Value first();

    /** Whether Java calculates with its values: whole and real numbers, and characters. */
    default boolean isNumber() {
        return false;
    }

    /** Whether a value is one of the type. */
    default boolean has(Value value) {
        return first().getClass() == value.getClass();
    }

    /** The name without its package. */
    default String simpleName() {
        return name();
    }

    record BooleanType() implements Type {
        @Override
        public String name() {
            return "Boolean";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.booleanType(this);
        }

        @Override
        public Value first() {
            return new Value.BooleanValue(false);
        }
    }

    /**
     * Whole numbers from {@code low} to {@code high}, both included.
     *
     * @param width the arithmetic that Java uses for it
     * @param ranged whether the model wrote the range; then an assignment outside is a model error
     */
    record IntegerType(Width width, long low, long high, boolean ranged) implements Type {
        public static IntegerType of(Width width) {
            return new IntegerType(width, width.low, width.high, false);
        }

        @Override
        public String name() {
            return ranged ? width.typeName + "[" + low + ".." + high + "]" : width.typeName;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.integerType(this);
        }

        @Override
        public Value first() {
            return new Value.IntegerValue(low <= 0 && 0 <= high ? 0 : low);
        }

        @Override
        public boolean isNumber() {
            return true;
        }

        @Override
        public boolean has(Value value) {
            return value instanceof Value.IntegerValue number
                    && low <= number.value()
                    && number.value() <= high;
        }
    }

    /** Java's integer types; {@code INT} is written {@code Integer} or {@code int}. */
    enum Width {
        BYTE("byte", Byte.MIN_VALUE, Byte.MAX_VALUE),
        SHORT("short", Short.MIN_VALUE, Short.MAX_VALUE),
        INT("Integer", Integer.MIN_VALUE, Integer.MAX_VALUE),
        LONG("Long", Long.MIN_VALUE, Long.MAX_VALUE);

        private final String typeName;
        private final long low;
        private final long high;

        Width(String typeName, long low, long high) {
            this.typeName = typeName;
            this.low = low;
            this.high = high;
        }
    }

    /** {@code Double} and {@code double}; with {@code single}, {@code float}. */
    record RealType(boolean single) implements Type {
        @Override
        public String name() {
            return single ? "float" : "Double";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.realType(this);
        }

        @Override
        public Value first() {
            return new Value.RealValue(0);
        }

        @Override
        public boolean isNumber() {
            return true;
        }

        /** As objects compare: what is no number is a value of both types. */
        @Override
        public boolean has(Value value) {
            return value instanceof Value.RealValue number
                    && Double.compare(rounded(number.value()), number.value()) == 0;
        }

        /** The number of this type that is nearest to another one. */
        public double rounded(double number) {
            return single ? (float) number : number;
        }

        /** The next larger one. */
        public double above(double number) {
            return single ? Math.nextUp((float) number) : Math.nextUp(number);
        }

        /** The next smaller one. */
        public double below(double number) {
            return single ? Math.nextDown((float) number) : Math.nextDown(number);
        }
    }

    record CharacterType() implements Type {
        @Override
        public String name() {
            return "char";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.characterType(this);
        }

        @Override
        public Value first() {
            return new Value.CharacterValue((char) 0);
        }

        @Override
        public boolean isNumber() {
            return true;
        }
    }

    record StringType() implements Type {
        @Override
        public String name() {
            return "String";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.stringType(this);
        }

        @Override
        public Value first() {
            return new Value.StringValue("");
        }
    }

    /** An enumeration of a class diagram; {@code name} is qualified. */
    record EnumType(String name, List<String> constants) implements Type {
        public EnumType {
            constants = List.copyOf(constants);
        }

        @Override
        public String simpleName() {
            return name.substring(name.lastIndexOf('.') + 1);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.enumType(this);
        }

        @Override
        public Value first() {
            return new Value.EnumValue(this, 0);
        }

        @Override
        public boolean has(Value value) {
            return value instanceof Value.EnumValue constant && constant.type().equals(this);
        }
    }

    /**
     * A class of a class diagram; {@code name} is qualified, inherited attributes come first.
     *
     * @param java the class of Java that it stands for; nobody reads the attributes then, which
     *     tell messages apart
     */
    record ClassType(String name, List<Attribute> attributes, Optional<JavaClass> java)
            implements Type {
        public ClassType {
            attributes = List.copyOf(attributes);
        }

        public ClassType(String name, List<Attribute> attributes) {
            this(name, attributes, Optional.empty());
        }

        /** A class of Java, whose messages differ in values of these attributes. */
        public ClassType(JavaClass java, List<Attribute> attributes) {
            this(java.text(), attributes, Optional.of(java));
        }

        /** With type arguments, if it has some. */
        @Override
        public String simpleName() {
            return name.replaceAll("[\\w$]+\\.", "");
        }

        /** The qualified name, without type arguments. */
        public String className() {
            return java.map(JavaClass::name).orElse(name);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.classType(this);
        }

        @Override
        public Value first() {
            return new Value.ObjectValue(
                    this, attributes.stream().map(each -> each.type().first()).toList());
        }

        @Override
        public boolean has(Value value) {
            return value instanceof Value.ObjectValue object && object.type().equals(this);
        }
    }

    record Attribute(String name, Type type) {}

    /**
     * A class of the Java library.
     *
     * @param name qualified
     * @param arguments empty for a class that takes none, or that is named without them
     */
    record JavaClass(String name, List<JavaArgument> arguments) {
        public JavaClass {
            arguments = List.copyOf(arguments);
        }

        /** As models and Java write it, with full names: {@code java.util.List<Integer>}. */
        String text() {
            return arguments.isEmpty()
                    ? name
                    : arguments.stream()
                            .map(each -> each.words() + each.type().map(Type::name).orElse(""))
                            .collect(Collectors.joining(", ", name + "<", ">"));
        }
    }

    /**
     * A type argument.
     *
     * @param words what stands in front of the type, {@code ? extends}, with a space behind it
     * @param type empty for any
     */
    record JavaArgument(String words, Optional<Type> type) {}
}
