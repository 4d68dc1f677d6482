package arcomat.lower.statements;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;

/** Statements mean what somebody who does one after the other would do. */
class StatementsMeaningTest {
    private static final int STEPS = 25;
    private static final String NOT_ENABLED = "not enabled";
    private static final String ERROR = "error";

    /** Literals out of a range, and divisions by a literal zero: they are told, and go wrong. */
    private static final Set<String> SURE_TO_FAIL = Set.of("ARC0322", "ARC0323");

    /** A message that only one branch reads: what the reference does with it, too. */
    private static final String SILENCING = "ARC0355";

    private static final String TOO_LARGE = "ARC0345";

    @Test
    void statementsAreDoneOneAfterTheOther() {
        compare(40);
    }

    @Tag("slow")
    @Test
    void manyStatementsAreDoneOneAfterTheOther() {
        compare(1_000);
    }

    private static void compare(int programs) {
        Map<String, Integer> seen = new HashMap<>();
        for (int seed = 0; seed < programs; seed++) {
            Random random = new Random(seed);
            Program program = DrawnProgram.of(random);
            Term guard = Term.silence("p", random.nextBoolean(), "--");
            boolean computed = seed % 3 == 0;
            boolean guarded = !computed && random.nextInt(4) == 0;
            String text =
                    computed
                            ? computed(program)
                            : text(program, guarded ? "[" + guard.text() + "] " : "");
            Optional<Component> component = component(text);
            if (component.isEmpty()) {
                seen.merge("too many ways", 1, Integer::sum);
                continue;
            }
            StepRelation ways = relation(component.get());
            StepRelation whole = relation(whole(component.get()));
            for (int step = 0; step < STEPS; step++) {
                Map<String, Object> messages = messages(random);
                Map<String, Object> variables = variables(random);
                boolean may =
                        !guarded
                                || guard.in(new Frame(messages, variables))
                                        .truth()
                                        .equals(Optional.of(true));
                String expected = may ? done(program, messages, variables) : NOT_ENABLED;
                for (StepRelation relation : List.of(ways, whole)) {
                    assertThat(taken(relation, messages, variables))
                            .as("seed %s, %s, %s in%n%s", seed, messages, variables, text)
                            .isEqualTo(expected);
                }
                seen.merge(expected.startsWith("o") ? "done" : expected, 1, Integer::sum);
            }
        }
        assertThat(seen).containsKeys("done", NOT_ENABLED, ERROR);
        assertThat(seen.get("done")).isGreaterThan(programs * STEPS / 5);
        assertThat(seen.getOrDefault("too many ways", 0)).isLessThan(programs / 10);
    }

    private static String text(Program program, String guard) {
        return """
        component C {
          timing instant;
          port in Integer p, in Boolean q, out Integer[0..9] o, out Boolean r;
          var Integer[-9..9] a = 0;
          var Boolean c = false;
          <<completion = "ignore">> automaton {
            variable Integer b = 0;
            state s, t;
            initial s / do { a = 0; c = false; };
            s -> t %s/ do {
              %s
            };
          }
        }
        """
                .formatted(guard, String.join("\n      ", program.lines()));
    }

    /** The same statements, without states. */
    private static String computed(Program program) {
        return """
        component C {
          timing instant;
          port in Integer p, in Boolean q, out Integer[0..9] o, out Boolean r;
          var Integer[-9..9] a = 0;
          var Boolean c = false;
          var Integer b = 0;
          init { a = 0; b = a; c = false; }
          <<completion = "ignore">> compute {
              %s
              a = a; b = b; c = c;
          }
        }
        """
                .formatted(String.join("\n      ", program.lines()));
    }

    private static Optional<Component> component(String text) {
        Parsed parsed = Parser.parse(new SourceFile("C.arc", text));
        assertThat(parsed.findings()).as(text).isEmpty();
        Workspace workspace =
                Workspace.of(
                        List.of(parsed.unit().orElseThrow()), Set.of(), HouseLanguages.reader());
        Set<String> findings =
                Checks.run(workspace, Profile.REQUIREMENTS).stream()
                        .map(Diagnostic::code)
                        .collect(Collectors.toSet());
        findings.removeAll(SURE_TO_FAIL);
        findings.remove(SILENCING);
        assertThat(findings).as(text).isSubsetOf(TOO_LARGE);
        if (!findings.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(Lowering.lower(workspace).components().get(0));
    }

    private static StepRelation relation(Component component) {
        return ComponentSemantics.of(component, List.of()).relations().get(0);
    }

    /** The same with statements that are done one by one, as where there are too many ways. */
    private static Component whole(Component component) {
        Automaton automaton = component.automata().get(0);
        List<Automaton.Transition> transitions = new ArrayList<>();
        for (Automaton.Transition each : automaton.transitions()) {
            boolean again =
                    !transitions.isEmpty()
                            && each.body().isPresent()
                            && each.isSameStatements(automaton.transitions().get(0));
            if (!again) {
                transitions.add(each.body().map(body -> whole(each, body)).orElse(each));
            }
        }
        return component.like(
                component.name(),
                component.ports(),
                new Component.Atomic(List.of(automaton.withTransitions(transitions))),
                component.span());
    }

    private static Automaton.Transition whole(Automaton.Transition way, Automaton.Body body) {
        return way.with(body.guard(), body.matches(), List.of(), List.of())
                .of(
                        new Automaton.Body(
                                body.guard(),
                                body.matches(),
                                body.statement(),
                                1,
                                Automaton.Standing.WHOLE));
    }

    private static Map<String, Object> messages(Random random) {
        Map<String, Object> messages = new LinkedHashMap<>();
        if (random.nextInt(4) > 0) {
            messages.put("p", random.nextInt(7) - 3);
        }
        if (random.nextInt(4) > 0) {
            messages.put("q", random.nextBoolean());
        }
        return messages;
    }

    private static Map<String, Object> variables(Random random) {
        Map<String, Object> variables = new LinkedHashMap<>();
        variables.put("a", random.nextInt(7) - 3);
        variables.put("c", random.nextBoolean());
        variables.put("b", random.nextInt(7) - 3);
        return variables;
    }

    /** What happens where each statement is done after the one before. */
    private static String done(
            Program program, Map<String, Object> messages, Map<String, Object> variables) {
        Frame frame = new Frame(messages, variables);
        try {
            program.run().accept(frame);
            List<Deferred> kept = new ArrayList<>();
            variables.keySet().forEach(name -> kept.add(frame.value(name)));
            frame.sent.values().forEach(each -> each.ifPresent(kept::add));
            if (!kept.stream().allMatch(each -> messages.keySet().containsAll(each.reads()))) {
                return NOT_ENABLED;
            }
            Map<String, String> sent = new HashMap<>();
            frame.sent.forEach(
                    (port, value) ->
                            value.ifPresent(
                                    each -> sent.put(port, String.valueOf(each.value().get()))));
            List<String> after = new ArrayList<>();
            variables.keySet().forEach(each -> after.add(frame.value(each).value().get() + ""));
            boolean inside =
                    Math.abs(Integer.parseInt(after.get(0))) <= 9
                            && Integer.parseInt(sent.getOrDefault("o", "0")) >= 0
                            && Integer.parseInt(sent.getOrDefault("o", "0")) <= 9;
            return inside
                    ? "o %s, r %s, then %s"
                            .formatted(
                                    sent.getOrDefault("o", "--"),
                                    sent.getOrDefault("r", "--"),
                                    after)
                    : ERROR;
        } catch (Program.NotEnabled missing) {
            return NOT_ENABLED;
        } catch (ArithmeticException division) {
            return ERROR;
        }
    }

    private static String taken(
            StepRelation relation, Map<String, Object> messages, Map<String, Object> variables) {
        Configuration before =
                new Configuration(
                        0,
                        variables.values().stream()
                                .map(StatementsMeaningTest::value)
                                .toArray(Value[]::new));
        Value[] slots = {value(messages.get("p")), value(messages.get("q"))};
        StepRelation.Prospect prospect = relation.prospect(before, Input.of(slots));
        if (!prospect.errors().isEmpty()) {
            return prospect.reactions().isEmpty() ? ERROR : "error and " + prospect.reactions();
        }
        assertThat(prospect.reactions()).hasSize(1);
        StepRelation.Reaction reaction = prospect.reactions().get(0);
        if (!(reaction.cause() instanceof Trace.Taken)) {
            return NOT_ENABLED;
        }
        return "o %s, r %s, then %s"
                .formatted(
                        reaction.output().ports().get(0),
                        reaction.output().ports().get(1),
                        reaction.next().variables());
    }

    private static Value value(Object value) {
        return value == null
                ? null
                : value instanceof Integer number
                        ? new Value.IntegerValue(number)
                        : new Value.BooleanValue((Boolean) value);
    }
}
