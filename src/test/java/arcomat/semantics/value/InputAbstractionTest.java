package arcomat.semantics.value;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Component.Profile;
import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.semantics.Expressions;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.AbstractionOfInputs;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Guards;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Term;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Copied;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.symbols.Scenario;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** What transitions look at: enough, whatever the guard, and, as data, no more than they need. */
class InputAbstractionTest {
    private static final Path LOOKS = Path.of("src/test/resources/semantics/abstraction.txt");
    private static final Guards GUARDS = new Guards(Profile.TIME_SYNCHRONOUS);

    @Provide
    Arbitrary<Expression> guards() {
        return Expressions.guards();
    }

    /** Letters that look alike, have the same steps. */
    @Property(seed = "1", tries = 500)
    void tellsLettersApartThatGuardsTellApart(@ForAll("guards") Expression guard) {
        Scope scope = new Scope(Expressions.COMPONENT, List.of());
        AbstractionOfInputs attentions = new AbstractionOfInputs(Expressions.COMPONENT, scope);
        Expression condition = Expressions.trueWhen(GUARDS, guard);
        attentions.condition(condition);
        List<PortAbstraction> looks = attentions.with(new Value[0]).looks();
        Term term = Evaluation.compile(condition, scope);
        Map<List<Object>, Boolean> known = new HashMap<>();
        for (Value[] letter : letters()) {
            boolean holds = term.holds(letter, new Value[0]);
            Boolean other = known.putIfAbsent(seen(looks, letter), holds);
            assertThat(other).as("%s %s", looks, List.of(condition)).isIn(null, holds);
        }
    }

    /** What somebody knows of a letter who looks at it like this. */
    private static List<Object> seen(List<PortAbstraction> looks, Value[] letter) {
        List<Object> seen = new ArrayList<>();
        for (int port = 0; port < letter.length; port++) {
            seen.add(seen(looks.get(port), letter[port]));
        }
        return seen;
    }

    private static Object seen(PortAbstraction look, Value message) {
        if (look instanceof Unseen) {
            return "";
        }
        if (message == null) {
            return "--";
        }
        if (!(look instanceof Compared compared) || compared.values().contains(message)) {
            return message;
        }
        return compared.ordered()
                ? compared.values().stream().filter(value -> value.compareTo(message) < 0).count()
                : "another";
    }

    private static List<Value[]> letters() {
        List<Value> flags = new ArrayList<>();
        flags.add(null);
        flags.add(new Value.BooleanValue(false));
        flags.add(new Value.BooleanValue(true));
        List<Value> numbers = new ArrayList<>();
        numbers.add(null);
        IntStream.range(-1, 4).forEach(n -> numbers.add(new Value.IntegerValue(n)));
        List<Value[]> letters = new ArrayList<>();
        for (Value p : flags) {
            for (Value q : flags) {
                for (Value m : numbers) {
                    numbers.stream().skip(1).forEach(n -> letters.add(new Value[] {p, q, m, n}));
                }
            }
        }
        return letters;
    }

    @TestFactory
    Stream<DynamicTest> looksNoCloserThanItNeeds() {
        Scenario scenario = Scenario.read(LOOKS);
        Component component =
                Lowering.lower(scenario.workspace()).component("a.Looks").orElseThrow();
        StepRelation relation = ComponentSemantics.of(component, List.of()).relations().get(0);
        return scenario.expected()
                .lines()
                .map(line -> line.split(" *->"))
                .map(line -> DynamicTest.dynamicTest(line[0], () -> check(relation, line)));
    }

    private static void check(StepRelation relation, String[] line) {
        String[] words = line[0].split(" ");
        String expected = line.length > 1 ? line[1].strip() : "";
        Value[] slots = relation.starts().get(0).configuration().slots().clone();
        slots[0] = new Value.IntegerValue(words.length > 1 ? Long.parseLong(words[1]) : 0);
        int state = relation.automaton().states().indexOf(words[0]);
        List<PortAbstraction> looks = relation.abstraction(new Configuration(state, slots)).looks();
        List<String> seen = new ArrayList<>();
        for (int port = 0; port < looks.size(); port++) {
            if (!(looks.get(port) instanceof Unseen)) {
                String name = relation.component().inputs().get(port).name();
                seen.add(name + " " + text(looks.get(port)));
            }
        }
        assertThat(String.join("; ", seen)).isEqualTo(expected);
    }

    private static String text(PortAbstraction look) {
        if (look instanceof Copied) {
            return "copied";
        }
        if (!(look instanceof Compared compared)) {
            return "whole";
        }
        String values =
                compared.values().stream().map(Value::toString).collect(Collectors.joining(", "));
        return (compared.ordered() ? "ordered " : "") + (values.isEmpty() ? "seen" : values);
    }
}
