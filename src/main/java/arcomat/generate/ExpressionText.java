package arcomat.generate;

import arcomat.generate.language.Language;
import arcomat.generate.language.Names;
import arcomat.generate.language.References;
import arcomat.generate.language.Text;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Interval;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Writes expressions in the target's language. How a form is spelt is a matter of the target's
 * table; which forms there are is a matter of the model.
 */
final class ExpressionText {
    private static final int LONGEST_ROW = 200;
    private static final String CALL = "call";
    private static final Type BOOLEAN = new Type.BooleanType();

    private final Names names;
    private final Language language;
    private final References references;
    private final Members members;
    private final Literals literals;

    /** The entries for operations that may go wrong. */
    private final String guarded;

    /** Where an expression stands, for the message of an error: transition or declaration. */
    private String place = "";

    /** How many operations that may go wrong have been written. */
    private int checks;

    /** Where variables are known to lie, beside what their types say. */
    private Map<String, Interval> known = Map.of();

    ExpressionText(Names names, References references, Members members) {
        this(names, references, members, "checked");
    }

    private ExpressionText(Names names, References references, Members members, String guarded) {
        this.guarded = guarded;
        this.names = names;
        this.language = names.language();
        this.references = references;
        this.members = members;
        this.literals = new Literals(names, references);
    }

    /** Expressions of what is only tried: it notes what goes wrong, and does not end for it. */
    ExpressionText careful() {
        return new ExpressionText(names, references, members, "careful");
    }

    boolean checks() {
        return checks > 0;
    }

    /** How many operations that may go wrong have been written so far. */
    int checksSoFar() {
        return checks;
    }

    void at(String newPlace) {
        place = newPlace;
    }

    /** From now on variables lie between bounds, where a condition says so. */
    void where(Formula condition) {
        known = new HashMap<>();
        for (Formula conjunct : condition.conjuncts()) {
            if (conjunct instanceof Formula.Test test && test.bounds().isPresent()) {
                Formula.Bounds bounds = test.bounds().get();
                Interval between = Interval.of(bounds.low(), bounds.high());
                known.merge(bounds.number(), between, Interval::within);
            }
        }
    }

    Text of(Expression e) {
        if (e instanceof Expression.Constant constant) {
            return of(constant.value(), constant.type());
        }
        if (e instanceof Expression.PortRead read) {
            return named("port", read.type(), members.of(read.port()));
        }
        if (e instanceof Expression.VariableRead read) {
            return named("variable", read.type(), members.of(read.variable()));
        }
        if (e instanceof Expression.ParameterRead read) {
            return named("parameter", read.type(), members.of(read.parameter()));
        }
        if (e instanceof Expression.AttributeRead read) {
            return attribute(read);
        }
        if (e instanceof Expression.PortMatches matches) {
            return text(new Formulas(this).of(matches));
        }
        if (e instanceof Expression.Unary unary) {
            String key = unary.operator().name().toLowerCase(Locale.ROOT);
            return language.express(key, unary.type(), Map.of(), List.of(of(unary.operand())));
        }
        if (e instanceof Expression.Binary binary) {
            return binary(binary);
        }
        if (e instanceof Expression.Conditional choice) {
            return language.express(
                    "conditional",
                    choice.type(),
                    Map.of(),
                    List.of(of(choice.condition()), of(choice.then()), of(choice.otherwise())));
        }
        if (e instanceof Expression.IsIn isIn) {
            return isIn(isIn);
        }
        if (e instanceof Expression.Cast cast) {
            return language.express("cast", cast.type(), Map.of(), List.of(of(cast.operand())));
        }
        throw new AssertionError(e);
    }

    private Text named(String key, Type type, String name) {
        return language.express(key, type, Map.of("name", name), List.of());
    }

    private Text attribute(Expression.AttributeRead read) {
        Type.ClassType type = (Type.ClassType) read.object().type();
        String name = names.attribute(type, read.index());
        return language.express(
                "attribute", read.type(), Map.of("name", name), List.of(of(read.object())));
    }

    private Text binary(Expression.Binary binary) {
        List<Text> operands = List.of(of(binary.left()), of(binary.right()));
        String key = binary.operator().name().toLowerCase(Locale.ROOT);
        Type type = binary.left().type();
        if (divides(binary)) {
            checks++;
            String guardedKey = guarded + "." + key;
            return language.express(guardedKey, type, Map.of("place", literal(place)), operands);
        }
        return language.express(key, type, Map.of(), operands);
    }

    /** Whether a division by zero has to be looked out for. */
    private static boolean divides(Expression.Binary binary) {
        return (binary.operator() == BinaryOperator.DIVIDE
                        || binary.operator() == BinaryOperator.REMAINDER)
                && binary.left().type() instanceof Type.IntegerType
                && !isNonZero(binary.right());
    }

    private static boolean isNonZero(Expression e) {
        return e instanceof Expression.Constant constant
                && constant.value() instanceof Value.IntegerValue integer
                && integer.value() != 0;
    }

    private Text isIn(Expression.IsIn isIn) {
        List<Text> tests = new ArrayList<>();
        for (Expression member : isIn.set()) {
            tests.add(equal(isIn.element(), member));
        }
        return joined("or", tests, false);
    }

    Text equal(Expression left, Expression right) {
        return binary(
                new Expression.Binary(BinaryOperator.EQUAL, left, right, BOOLEAN, left.span()));
    }

    Text notEqual(Expression left, Expression right) {
        return binary(
                new Expression.Binary(BinaryOperator.NOT_EQUAL, left, right, BOOLEAN, left.span()));
    }

    /** A literal of the target. */
    public Text of(Value value, Type type) {
        return literals.of(value, type);
    }

    /** A string literal of the target. */
    String literal(String content) {
        return literals.string(content);
    }

    /** The name of a type. */
    String type(Type type) {
        return language.express("type", type, Map.of("type", reference(type)), List.of()).text();
    }

    private String reference(Type type) {
        boolean named = type instanceof Type.EnumType || type instanceof Type.ClassType;
        return named ? references.to(names.of(type)) : "";
    }

    /** That a port carries a message, or that it carries none. */
    Text presence(Port port, boolean present) {
        return language.express(
                present ? "present" : "absent",
                port.type(),
                Map.of(
                        "name", members.of(port),
                        "flag", members.flag(port),
                        "type", reference(port.type())),
                List.of());
    }

    boolean mayBeAbsent(Port port) {
        return port.type() instanceof Type.EnumType ? !port.total() : !members.flag(port).isEmpty();
    }

    /** A message, or the value of a variable, as a monitor compares it; checked for its range. */
    String code(Expression value, Type wanted, String what) {
        return code(inRange(value, wanted, what), wanted);
    }

    /** The message on a port as a monitor compares it. */
    String code(Port port) {
        return code(named("port", port.type(), members.of(port)), port.type());
    }

    private String code(Text value, Type type) {
        return language.express("code", type, Map.of(), List.of(value)).text();
    }

    /** The value of a variable out of what a monitor keeps. */
    String decoded(int variable, Type type) {
        Text position = Text.primary(String.valueOf(variable));
        Map<String, String> filled = Map.of("type", reference(type));
        return language.express("decoded", type, filled, List.of(position)).text();
    }

    /** What a monitor says about a message. */
    String spelt(String code, Type type) {
        Map<String, String> filled = Map.of("type", reference(type));
        return language.express("spelt", type, filled, List.of(Text.primary(code))).text();
    }

    /** A value checked against the range of what it is for. */
    Text inRange(Expression value, Type wanted, String what) {
        Text text = of(value);
        if (!(wanted instanceof Type.IntegerType range) || !range.ranged() || fits(value, range)) {
            return text;
        }
        checks++;
        return language.express(
                guarded + ".range",
                wanted,
                Map.of(
                        "low", literals.of(range.low(), wanted).text(),
                        "high", literals.of(range.high(), wanted).text(),
                        "place", literal(place + ": " + what)),
                List.of(text));
    }

    /** A message keeps its range; but nothing is concluded of what others may have sent. */
    private boolean fits(Expression value, Type.IntegerType range) {
        Interval possible =
                value instanceof Expression.PortRead
                        ? Interval.ofType(value)
                        : Interval.of(value, this::read);
        return possible.isWithin(Interval.of(range.low(), range.high()));
    }

    private Interval read(Expression e) {
        if (e instanceof Expression.VariableRead read) {
            Interval type = Interval.ofType(e);
            Interval narrower = known.get(of(read).text());
            return narrower == null ? type : type.within(narrower);
        }
        return e instanceof Expression.ParameterRead
                ? Interval.ofType(e)
                : Interval.ofWidth(e.type());
    }

    /** Whether a part of a condition may be a method of its own. */
    boolean calls() {
        return language.entry("expression." + CALL).isPresent();
    }

    /** A call of a method that says whether something holds. */
    Text call(String method) {
        return language.express(CALL, BOOLEAN, Map.of("name", method), List.of());
    }

    /** A condition in the target's language. */
    Text text(Formula formula) {
        if (formula instanceof Formula.Truth truth) {
            return of(new Value.BooleanValue(truth.value()), BOOLEAN);
        }
        if (formula instanceof Formula.Carries carries) {
            return presence(carries.port(), carries.something());
        }
        if (formula instanceof Formula.Is is) {
            return is.text();
        }
        if (formula instanceof Formula.Test test) {
            return test.text();
        }
        if (formula instanceof Formula.Not not) {
            return language.express("not", BOOLEAN, Map.of(), List.of(text(not.operand())));
        }
        if (formula instanceof Formula.And and) {
            return joined("and", and.operands().stream().map(this::text).toList(), true);
        }
        Formula.Or or = (Formula.Or) formula;
        return joined("or", or.operands().stream().map(this::text).toList(), false);
    }

    /** Of very many in groups, and groups of groups: compilers have no room for deep nesting. */
    private Text joined(String operator, List<Text> operands, boolean ifNone) {
        if (operands.size() > LONGEST_ROW) {
            List<Text> groups = new ArrayList<>();
            for (int i = 0; i < operands.size(); i += LONGEST_ROW) {
                int end = Math.min(i + LONGEST_ROW, operands.size());
                groups.add(joined(operator, operands.subList(i, end), ifNone));
            }
            return joined(operator, groups, ifNone);
        }
        return operands.stream()
                .reduce((a, b) -> language.express(operator, BOOLEAN, Map.of(), List.of(a, b)))
                .orElseGet(() -> of(new Value.BooleanValue(ifNone), BOOLEAN));
    }

    /** Whether a value may divide by zero or lie outside the range of what it is for. */
    boolean mayFail(Expression value, Type wanted) {
        return wanted instanceof Type.IntegerType range && range.ranged() && !fits(value, range)
                || value.contains(e -> e instanceof Expression.Binary binary && divides(binary));
    }

    /** The field of a port as the target of an assignment. */
    String target(Port port) {
        return named("port", port.type(), members.of(port)).text();
    }

    String flagTarget(Port port) {
        return named("flag", BOOLEAN, members.flag(port)).text();
    }

    String target(Variable variable) {
        return named("variable", variable.type(), members.of(variable)).text();
    }

    String truth(boolean value) {
        return of(new Value.BooleanValue(value), BOOLEAN).text();
    }

    /**
     * A field of a part.
     *
     * @param part empty for the component itself
     */
    String member(String part, String name) {
        String key = part.isEmpty() ? "port" : "member";
        return language.express(key, BOOLEAN, Map.of("part", part, "name", name), List.of()).text();
    }

    /** The code of no message. */
    Text silence(Port port) {
        String type = references.to(names.of(port.type()));
        return language.express("silence", port.type(), Map.of("type", type), List.of());
    }
}
