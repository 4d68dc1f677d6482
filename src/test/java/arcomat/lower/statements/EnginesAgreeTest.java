package arcomat.lower.statements;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.compile.Agreement;
import arcomat.pipeline.compile.CompiledModel;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;

/** Interpreter and compiled code do the same with arbitrary statements, errors included. */
class EnginesAgreeTest {
    private static final int AT_ONCE = 25;
    private static final int WORDS = 12;
    private static final int LETTERS = 8;

    /** Literals out of a range, and divisions by a literal zero: they are told, and go wrong. */
    private static final Set<String> SURE_TO_FAIL = Set.of("ARC0322", "ARC0323");

    @Test
    void onStatements() {
        assertThat(compared(0, AT_ONCE)).isPositive();
    }

    @Tag("slow")
    @Test
    void onManyStatements() {
        int models = Integer.getInteger("statements", 400);
        int compared = 0;
        for (int first = 0; first < models; first += AT_ONCE) {
            compared += compared(first, AT_ONCE);
        }
        assertThat(compared).isGreaterThan(models / 2);
    }

    /**
     * How many of some models have been compared; others go wrong for certain, or are too large.
     */
    private static int compared(int first, int count) {
        List<String> names = new ArrayList<>();
        List<SourceFile> files = new ArrayList<>();
        for (int seed = first; seed < first + count; seed++) {
            SourceFile file = new SourceFile("C" + seed + ".arc", text(seed));
            if (isRight(file)) {
                names.add("C" + seed);
                files.add(file);
            }
        }
        List<String> events = names.stream().filter(each -> isEventDriven(number(each))).toList();
        List<String> slices = names.stream().filter(each -> !events.contains(each)).toList();
        files.add(whole("Slices", "", slices));
        files.add(whole("Events", "timing untimed;", events));
        Model model = Lowering.lower(workspace(files));
        Choosing choosing = first / AT_ONCE % 2 == 0 ? Choosing.FIRST : Choosing.RANDOM;
        for (String name : List.of("Slices", "Events")) {
            Component whole = model.component(name).orElseThrow();
            CompiledModel all = compiled(whole, choosing);
            for (String each : name.equals("Slices") ? slices : events) {
                Component component = model.component(each).orElseThrow();
                new Agreement(component, List.of()).holdsIn(all, WORDS, LETTERS);
            }
        }
        return names.size();
    }

    /** Of very many ways none is drawn: the first one is taken then. */
    private static CompiledModel compiled(Component whole, Choosing choosing) {
        try {
            return CompiledModel.of(whole, choosing);
        } catch (IllegalStateException tooManyToDraw) {
            assertThat(tooManyToDraw).hasMessageContaining("--choose first");
            return CompiledModel.of(whole, Choosing.FIRST);
        }
    }

    private static int number(String name) {
        return Integer.parseInt(name.substring(1));
    }

    private static boolean isEventDriven(int seed) {
        return seed % 5 == 4;
    }

    private static SourceFile whole(String name, String timing, List<String> parts) {
        StringBuilder text = new StringBuilder("component " + name + " {\n  " + timing + "\n");
        parts.forEach(each -> text.append("  component %s x%s;\n".formatted(each, each)));
        return new SourceFile(name + ".arc", text + "}\n");
    }

    private static boolean isRight(SourceFile file) {
        Set<String> codes =
                Set.copyOf(
                        Checks.run(workspace(List.of(file)), Profile.REQUIREMENTS).stream()
                                .filter(Diagnostic::isError)
                                .map(Diagnostic::code)
                                .distinct()
                                .toList());
        assertThat(codes)
                .as(file.text())
                .isSubsetOf(Set.of("ARC0345", "ARC0322", "ARC0323", "ARC0320"));
        return SURE_TO_FAIL.containsAll(codes);
    }

    private static Workspace workspace(List<SourceFile> files) {
        List<Unit> units = new ArrayList<>();
        for (SourceFile file : files) {
            Parsed parsed = Parser.parse(file);
            assertThat(parsed.findings()).as(file.text()).isEmpty();
            units.add(parsed.unit().orElseThrow());
        }
        return Workspace.of(units, Set.of(), HouseLanguages.reader());
    }

    private static String text(int seed) {
        Random random = new Random(seed);
        String ports =
                "port %sin Integer[-3..3] p, %sin Boolean q, out Integer[0..9] o, out Boolean r;"
                        .formatted(total(random, seed), total(random, seed));
        String timing =
                isEventDriven(seed)
                        ? "timing untimed;"
                        : random.nextBoolean() ? "timing instant;" : "";
        return seed % 5 < 2
                ? computed(seed, timing, ports, DrawnProgram.of(random))
                : automaton(seed, timing, ports, random);
    }

    private static String total(Random random, int seed) {
        return !isEventDriven(seed) && random.nextInt(3) == 0 ? "<<total>> " : "";
    }

    private static String automaton(int seed, String timing, String ports, Random random) {
        List<String> transitions =
                IntStream.range(0, 1 + random.nextInt(3))
                        .mapToObj(i -> transition(random))
                        .toList();
        return """
        component C%d {
          %s
          %s
          var Integer[-9..9] a = 0;
          var Boolean c = false;
          <<completion = "%s">> automaton {
            variable Integer b = 0;
            state s, t;
            initial s / do { a = 0; c = false; };
            %s
          }
        }
        """
                .formatted(
                        seed,
                        timing,
                        ports,
                        random.nextBoolean() ? "ignore" : "chaos",
                        String.join("\n    ", transitions));
    }

    private static String transition(Random random) {
        String[] states = {"s -> t", "t -> s", "s -> s"};
        String[] guards = {"", "[q == true] ", "[p == -- || p > 1] ", "{p = ?} "};
        return "%s %s/ do {\n      %s\n    };"
                .formatted(
                        states[random.nextInt(states.length)],
                        guards[random.nextInt(guards.length)],
                        String.join("\n      ", DrawnProgram.of(random).lines()));
    }

    private static String computed(int seed, String timing, String ports, Program program) {
        return """
        component C%d {
          %s
          %s
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
                .formatted(seed, timing, ports, String.join("\n      ", program.lines()));
    }
}
