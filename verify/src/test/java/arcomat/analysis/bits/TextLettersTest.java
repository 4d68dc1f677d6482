package arcomat.analysis.bits;

import static arcomat.semantics.ComponentBuilder.NOWHERE;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;

/**
 * Texts in letters: what is found is what the interpreter says, and where nothing is found, no text
 * will do. The words that conditions mention are those that a solver makes up itself.
 */
class TextLettersTest {
    private static final Type TRUTH = new Type.BooleanType();
    private static final Type TEXT = new Type.StringType();
    private static final Type INT = Type.IntegerType.of(Type.Width.INT);
    private static final Type DOUBLE = new Type.RealType(false);
    private static final Type LETTER = new Type.CharacterType();
    private static final List<Port> PORTS =
            List.of(port("a", TEXT), port("b", TEXT), port("c", TEXT));
    private static final List<String> WORDS = List.of("", "text 1", "text 2");
    private static final int LESSONS = 20;

    private static Port port(String name, Type type) {
        return new Port(name, Port.Direction.IN, type, false, 0, false, NOWHERE);
    }

    private static Expression read(Port port) {
        return new Expression.PortRead(port, NOWHERE);
    }

    private static Expression text(String text) {
        return new Expression.Constant(new Value.StringValue(text), TEXT, NOWHERE);
    }

    private static Expression.Binary binary(
            BinaryOperator operator, Expression one, Expression other, Type type) {
        return new Expression.Binary(operator, one, other, type, NOWHERE);
    }

    private static Expression equal(Expression one, Expression other) {
        return binary(BinaryOperator.EQUAL, one, other, TRUTH);
    }

    private static Expression different(Expression one, Expression other) {
        return binary(BinaryOperator.NOT_EQUAL, one, other, TRUTH);
    }

    /** All that three texts can be: words that are mentioned, and three others. */
    @Property(tries = 300, seed = "1")
    void findsWhatThereIs(@ForAll long seed) {
        Random random = new Random(seed);
        Expression condition = condition(4, random);
        boolean possible = letters().anyMatch(letter -> isTrue(condition, PORTS, letter));
        Optional<Value[]> found = found(PORTS, Map.of(), condition);
        assertThat(found.isPresent()).as("%s", condition).isEqualTo(possible);
        found.ifPresent(letter -> assertThat(isTrue(condition, PORTS, letter)).isTrue());
    }

    private static Optional<Value[]> found(
            List<Port> ports, Map<Port, Port> same, Expression condition) {
        BitLetters letters = new BitLetters(ports, same, LESSONS, () -> false);
        letters.claim(letters.truth(condition));
        return letters.find();
    }

    private static boolean isTrue(Expression condition, List<Port> ports, Value[] letter) {
        return Evaluation.compile(condition, Scope.ofPorts(ports)).isTrue(letter, new Value[0]);
    }

    private static Stream<Value[]> letters() {
        List<Value> all =
                Stream.concat(WORDS.stream(), Stream.of("x", "y", "z"))
                        .<Value>map(Value.StringValue::new)
                        .toList();
        return all.stream()
                .flatMap(
                        a ->
                                all.stream()
                                        .flatMap(
                                                b -> all.stream().map(c -> new Value[] {a, b, c})));
    }

    private static Expression condition(int depth, Random random) {
        if (depth == 0) {
            return switch (random.nextInt(4)) {
                case 0 -> equal(operand(random), operand(random));
                case 1 -> different(operand(random), operand(random));
                case 2 ->
                        new Expression.PortMatches(
                                PORTS.get(random.nextInt(3)),
                                new Automaton.OneOf(List.of(operand(random), operand(random))),
                                NOWHERE);
                default ->
                        new Expression.IsIn(
                                operand(random),
                                List.of(operand(random), operand(random)),
                                NOWHERE);
            };
        }
        BinaryOperator operator = random.nextInt(3) > 0 ? BinaryOperator.AND : BinaryOperator.OR;
        return binary(operator, condition(depth - 1, random), condition(depth - 1, random), TRUTH);
    }

    private static Expression operand(Random random) {
        return switch (random.nextInt(5)) {
            case 0 -> text(WORDS.get(random.nextInt(WORDS.size())));
            case 1 ->
                    new Expression.Conditional(
                            equal(read(PORTS.get(0)), text("text 1")),
                            read(PORTS.get(1)),
                            text("text 2"),
                            TEXT,
                            NOWHERE);
            default -> read(PORTS.get(random.nextInt(3)));
        };
    }

    /** Numbers of texts are in no order, and are no numbers to calculate with. */
    @Test
    void nothingElseIsAskedOfTexts() {
        Expression a = read(PORTS.get(0));
        Expression b = read(PORTS.get(1));
        List<Expression> others = new ArrayList<>();
        others.add(binary(BinaryOperator.LESS, a, b, TRUTH));
        others.add(binary(BinaryOperator.GREATER_OR_EQUAL, a, b, TRUTH));
        others.add(equal(a, read(port("n", INT))));
        others.add(equal(new Expression.Cast(a, INT, NOWHERE), read(port("n", INT))));
        others.add(equal(new Expression.Cast(read(port("n", INT)), TEXT, NOWHERE), a));
        others.add(equal(binary(BinaryOperator.MINUS, a, b, TEXT), a));
        others.add(
                equal(
                        new Expression.Conditional(
                                equal(a, b), read(port("n", INT)), a, TEXT, NOWHERE),
                        b));
        for (Expression each : others) {
            assertThatThrownBy(() -> found(List.of(), Map.of(), each))
                    .as("%s", each)
                    .isInstanceOf(GivenUp.class)
                    .hasMessageContaining("no bits for '");
        }
    }

    /** Sums of numbers would commute. */
    @Test
    void textsThatArePutTogetherAreTheSameForTheSame() {
        Expression a = read(PORTS.get(0));
        Expression b = read(PORTS.get(1));
        Expression ab = joined(a, b);
        assertThat(found(PORTS, Map.of(), different(ab, joined(a, b)))).isEmpty();
        assertThat(found(PORTS, Map.of(), different(joined(ab, a), joined(joined(a, b), a))))
                .isEmpty();
        Expression turned = different(ab, joined(b, a));
        Value[] letter = found(PORTS, Map.of(), turned).orElseThrow();
        assertThat(isTrue(turned, PORTS, letter)).isTrue();
        assertThatThrownBy(() -> found(PORTS, Map.of(), different(joined(a, text("")), a)))
                .isInstanceOf(GivenUp.class)
                .hasMessage("what 'a + \"\"' gives has no circuit");
    }

    private static Expression joined(Expression one, Expression other) {
        return binary(BinaryOperator.PLUS, one, other, TEXT);
    }

    /** The same bits may be a letter and a number, which are two texts. */
    @Test
    void textsOfDifferentTypesAreDifferent() {
        Port letter = port("l", LETTER);
        Expression code = new Expression.Cast(read(letter), INT, NOWHERE);
        Expression one = joined(text(""), read(letter));
        Expression other = joined(text(""), code);
        assertThat(found(List.of(letter), Map.of(), different(one, other))).isPresent();
    }

    /** There is one message that is no number, whatever a solver takes for it. */
    @Test
    void remaindersAreNumbersOfModels() {
        Port x = port("x", DOUBLE);
        Port y = port("y", DOUBLE);
        List<Port> ports = List.of(x, y);
        Expression rest = binary(BinaryOperator.REMAINDER, read(x), read(y), DOUBLE);
        BitLetters letters = new BitLetters(ports, Map.of(), LESSONS, () -> false);
        letters.claim(letters.is(read(y), new Value.RealValue(0)));
        letters.claim(-letters.is(rest, new Value.RealValue(Double.NaN)));
        assertThatThrownBy(letters::find)
                .isInstanceOf(GivenUp.class)
                .hasMessage("what 'x % y' gives has no circuit");
    }

    /** What is calculated in the same way from the same is the same, also where it is hard. */
    @Test
    void whatIsTheSameIsNotAsked() {
        Port x = port("x", DOUBLE);
        Port y = port("y", DOUBLE);
        Port z = port("z", DOUBLE);
        Expression one = binary(BinaryOperator.MULTIPLY, read(x), read(z), DOUBLE);
        Expression other = binary(BinaryOperator.MULTIPLY, read(z), read(y), DOUBLE);
        BitLetters letters = new BitLetters(List.of(x, y, z), Map.of(y, x), LESSONS, () -> false);
        letters.claim(-letters.areSame(one, other));
        assertThat(letters.find()).isEmpty();
        BitLetters others = new BitLetters(List.of(x, y, z), Map.of(y, x), LESSONS, () -> false);
        others.claim(others.is(read(x), new Value.RealValue(-0.0)));
        assertThat(others.find().orElseThrow()[1]).isEqualTo(new Value.RealValue(-0.0));
    }
}
