package arcomat.generate.text;

import arcomat.generate.language.FileReferences;
import arcomat.generate.language.TargetLanguage;
import arcomat.generate.language.TargetNames;
import arcomat.generate.language.Text;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Writes expressions and conditions in the target's language. How a form is spelt is a matter of
 * the target's table; which forms there are is a matter of the model. Whether a text looks out for
 * what may go wrong is asked of {@link RuntimeChecks}.
 */
public final class ExpressionWriter implements Expression.Cases<Text> {
    private static final int LONGEST_ROW = 200;
    private static final String CALL = "call";
    private static final String CONDITIONAL = "conditional";
    private static final String JUDGED = "judged.";
    private static final String TRUNCATE = "truncate";
    private static final Type BOOLEAN = new Type.BooleanType();

    private final TargetNames names;
    private final TargetLanguage language;
    private final FileReferences references;
    private final MemberNames members;
    private final LiteralWriter literals;

    /** The entries for operations that may go wrong. */
    private final String guarded;

    private final RuntimeChecks checks;

    /** Where an expression stands, for the message of an error: transition or declaration. */
    private final String place;

    ExpressionWriter(TargetNames names, FileReferences references, MemberNames members) {
        this(names, references, members, "checked", RuntimeChecks.ANYWHERE, "");
    }

    private ExpressionWriter(
            TargetNames names,
            FileReferences references,
            MemberNames members,
            String guarded,
            RuntimeChecks checks,
            String place) {
        this.names = names;
        this.language = names.language();
        this.references = references;
        this.members = members;
        this.literals = new LiteralWriter(names, references);
        this.guarded = guarded;
        this.checks = checks;
        this.place = place;
    }

    /** Expressions of what is only tried: it notes what goes wrong, and does not end for it. */
    public ExpressionWriter careful() {
        return new ExpressionWriter(names, references, members, "careful", checks, place);
    }

    /** Expressions of a transition or declaration. */
    public ExpressionWriter at(String newPlace) {
        return new ExpressionWriter(names, references, members, guarded, checks, newPlace);
    }

    /** Expressions that are computed where a condition holds. */
    public ExpressionWriter where(Formula condition) {
        RuntimeChecks known = RuntimeChecks.where(condition);
        return new ExpressionWriter(names, references, members, guarded, known, place);
    }

    /** Where these expressions stand. */
    String place() {
        return place;
    }

    /** What is to be looked out for in these expressions. */
    public RuntimeChecks checks() {
        return checks;
    }

    public Text of(Expression e) {
        return e.match(this);
    }

    /** A condition. */
    public Text of(Formula formula) {
        return formula.match(
                new Formula.Cases<>(
                        this::presence,
                        Formula.Is::text,
                        Formula.Test::text,
                        not -> form("not", BOOLEAN, of(not.operand())),
                        row -> joined(row.all(), row.operands().stream().map(this::of).toList()),
                        judged -> of(judged.condition())));
    }

    /** A literal. */
    public Text of(Value value, Type type) {
        return literals.of(value, type);
    }

    /** A string literal. */
    public String literal(String content) {
        return literals.string(content);
    }

    /** The name of a type. */
    public String type(Type type) {
        return literals.type(type);
    }

    public String truth(boolean value) {
        return of(new Value.BooleanValue(value), BOOLEAN).text();
    }

    /** Fills in an entry of the target's table that may ask for the name of the type. */
    public Text express(String key, Type type, Text... operands) {
        return language.express(key, type, Map.of("type", literals.reference(type)), operands);
    }

    private Text form(String key, Type type, Text... operands) {
        return language.express(key, type, Map.of(), operands);
    }

    private Text named(String key, Type type, String name, Text... operands) {
        return language.express(key, type, Map.of("name", name), operands);
    }

    @Override
    public Text constant(Expression.Constant constant) {
        return of(constant.value(), constant.type());
    }

    @Override
    public Text portRead(Expression.PortRead read) {
        return of(read.port());
    }

    /** The field of a port. */
    public Text of(Port port) {
        return named("port", port.type(), members.of(port));
    }

    /** The field that says whether a port carries a message. */
    public Text flag(Port port) {
        return named("flag", BOOLEAN, members.flag(port));
    }

    @Override
    public Text variableRead(Expression.VariableRead read) {
        return of(read.variable());
    }

    public Text of(Variable variable) {
        return named("variable", variable.type(), members.of(variable));
    }

    @Override
    public Text parameterRead(Expression.ParameterRead read) {
        return named("parameter", read.type(), members.of(read.parameter()));
    }

    @Override
    public Text attributeRead(Expression.AttributeRead read) {
        Type.ClassType type = (Type.ClassType) read.object().type();
        return named(
                "attribute", read.type(), names.attribute(type, read.index()), of(read.object()));
    }

    @Override
    public Text portMatches(Expression.PortMatches matches) {
        return of(new FormulaBuilder(this).of(matches));
    }

    @Override
    public Text unary(Expression.Unary unary) {
        return form(key(unary.operator()), unary.type(), of(unary.operand()));
    }

    @Override
    public Text binary(Expression.Binary binary) {
        Text left = of(binary.left());
        Text right = of(binary.right());
        String key = key(binary.operator());
        Type type = binary.left().type();
        return RuntimeChecks.isNeeded(binary)
                ? language.express(
                        guarded + "." + key, type, Map.of("place", literal(place)), left, right)
                : form(key, type, left, right);
    }

    private static String key(Enum<?> operator) {
        return operator.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public Text conditional(Expression.Conditional choice) {
        return form(
                CONDITIONAL,
                choice.type(),
                of(choice.condition()),
                of(choice.then()),
                of(choice.otherwise()));
    }

    @Override
    public Text isIn(Expression.IsIn isIn) {
        return joined(false, isIn.set().stream().map(each -> equal(isIn.element(), each)).toList());
    }

    @Override
    public Text cast(Expression.Cast cast) {
        String key = RuntimeChecks.isNeeded(cast) && truncates() ? TRUNCATE : "cast";
        return form(key, cast.type(), of(cast.operand()));
    }

    /** Whether the target has other words for a conversion of numbers beyond 64 bits. */
    private boolean truncates() {
        return language.entry("expression." + TRUNCATE + ".long").isPresent();
    }

    Text equal(Expression left, Expression right) {
        return compared(BinaryOperator.EQUAL, left, right);
    }

    Text notEqual(Expression left, Expression right) {
        return compared(BinaryOperator.NOT_EQUAL, left, right);
    }

    private Text compared(BinaryOperator operator, Expression left, Expression right) {
        return binary(new Expression.Binary(operator, left, right, BOOLEAN, left.span()));
    }

    /** That a port carries a message, or that it carries none. */
    private Text presence(Formula.Carries carries) {
        Port port = carries.port();
        return language.express(
                carries.something() ? "present" : "absent",
                port.type(),
                Map.of(
                        "name", members.of(port),
                        "flag", members.flag(port),
                        "type", literals.reference(port.type())));
    }

    public boolean mayBeAbsent(Port port) {
        return port.type() instanceof Type.EnumType ? !port.total() : !members.flag(port).isEmpty();
    }

    /** Of very many in groups, and groups of groups: compilers have no room for deep nesting. */
    private Text joined(boolean all, List<Text> operands) {
        if (operands.size() > LONGEST_ROW) {
            List<Text> groups = new ArrayList<>();
            for (int i = 0; i < operands.size(); i += LONGEST_ROW) {
                int end = Math.min(i + LONGEST_ROW, operands.size());
                groups.add(joined(all, operands.subList(i, end)));
            }
            return joined(all, groups);
        }
        return operands.stream()
                .reduce((a, b) -> form(all ? "and" : "or", BOOLEAN, a, b))
                .orElseGet(() -> of(new Value.BooleanValue(all), BOOLEAN));
    }

    /** Has methods of its own, which are called by whoever asks for it. */
    @Override
    public Text judged(Expression.Judged judged) {
        throw new AssertionError(judged);
    }

    /** Whether the target has words for conditions that are judged, and for their methods. */
    public boolean judges() {
        return calls() && language.entry("expression.judged.true").isPresent();
    }

    /** What is known of a condition, by what is known of its operands. */
    public Text judged(String form, Text... operands) {
        return form(JUDGED + form, BOOLEAN, operands);
    }

    /** That what is known of a condition says that it is true, or an error. */
    public Text judgedTrue(Text known) {
        return language.express(JUDGED + "true", BOOLEAN, Map.of("place", literal(place)), known);
    }

    /** One of two texts. */
    public Text choice(Text condition, Text then, Text otherwise) {
        return form(CONDITIONAL, BOOLEAN, condition, then, otherwise);
    }

    /** A value checked against the range of what it is for. */
    public Text inRange(Expression value, Type wanted, String what) {
        Text text = of(value);
        if (!checks.isNeeded(value, wanted)) {
            return text;
        }
        Type.IntegerType range = (Type.IntegerType) wanted;
        return language.express(
                guarded + ".range",
                wanted,
                Map.of(
                        "low", of(new Value.IntegerValue(range.low()), wanted).text(),
                        "high", of(new Value.IntegerValue(range.high()), wanted).text(),
                        "place", literal(place + ": " + what)),
                text);
    }

    /** Whether a part of a condition may be a method of its own. */
    public boolean calls() {
        return language.entry("expression." + CALL).isPresent();
    }

    /** A call of a method that says whether something holds. */
    public Text call(String method) {
        return named(CALL, BOOLEAN, method);
    }

    /**
     * A field of a part.
     *
     * @param part empty for the component itself
     */
    public String member(String part, String name) {
        String key = part.isEmpty() ? "port" : "member";
        return language.express(key, BOOLEAN, Map.of("part", part, "name", name)).text();
    }
}
