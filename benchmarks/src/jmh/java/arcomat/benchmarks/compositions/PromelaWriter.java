package arcomat.benchmarks.compositions;

import arcomat.benchmarks.compositions.PartKind.Rule;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A system for Spin: one process, whose loop chooses inputs and ways first, and then makes a slice
 * of all parts in one {@code d_step}. What was chosen is forgotten there, so that a state is what
 * the parts are in and what they have sent.
 */
final class PromelaWriter {
    private PromelaWriter() {}

    static String text(ComposedSystem system) {
        List<String> declarations = new ArrayList<>();
        List<String> choices = new ArrayList<>();
        List<String> steps = new ArrayList<>();
        List<String> ends = new ArrayList<>();
        for (int i = 0; i < system.externals(); i++) {
            declarations.add("bit e%d;".formatted(i));
            choices.add("if :: e%d = 0 :: e%d = 1 fi;".formatted(i, i));
            ends.add("e%d = 0;".formatted(i));
        }
        for (int p = 0; p < system.parts().size(); p++) {
            PartKind kind = system.kind(system.parts().get(p));
            declarations.add("byte s%d, o%d = %d;".formatted(p, p, kind.first()));
            declarations.add("hidden byte n%d;".formatted(p));
            if (kind.choices() > 1) {
                declarations.add("byte c%d;".formatted(p));
                choices.add(choice(system, p));
                ends.add("c%d = 0;".formatted(p));
            }
            steps.add(step(system, p));
            ends.add("o%d = n%d;".formatted(p, p));
        }
        system.forbidden().forEach(all -> ends.add("assert(!(%s));".formatted(sights(all))));
        return """
        %s
        active proctype whole() {
          do
          :: atomic {
            %s
            d_step {
              %s
              %s
            }
          }
          od
        }
        """
                .formatted(
                        String.join("\n", declarations),
                        String.join("\n    ", choices),
                        String.join("\n      ", steps),
                        String.join("\n      ", ends));
    }

    /** Only where there is something to choose. */
    private static String choice(ComposedSystem system, int part) {
        StringBuilder text = new StringBuilder("if");
        for (Rule rule : system.kind(system.parts().get(part)).rules()) {
            if (rule.ways().size() > 1) {
                String options =
                        IntStream.range(0, rule.ways().size())
                                .mapToObj(way -> ":: c%d = %d".formatted(part, way))
                                .collect(Collectors.joining(" "));
                text.append(" :: %s -> if %s fi".formatted(when(system, part, rule), options));
            }
        }
        return text.append(" :: else fi;").toString();
    }

    private static String step(ComposedSystem system, int part) {
        StringBuilder text = new StringBuilder("if");
        for (Rule rule : system.kind(system.parts().get(part)).rules()) {
            for (int w = 0; w < rule.ways().size(); w++) {
                String chosen = rule.ways().size() > 1 ? " && c%d == %d".formatted(part, w) : "";
                PartKind.Way way = rule.ways().get(w);
                text.append(
                        " :: %s%s -> s%d = %d; n%d = %d"
                                .formatted(
                                        when(system, part, rule),
                                        chosen,
                                        part,
                                        way.state(),
                                        part,
                                        way.sends()));
            }
        }
        return text.append(" fi;").toString();
    }

    private static String when(ComposedSystem system, int part, Rule rule) {
        List<Integer> sources = system.parts().get(part).sources();
        StringBuilder text = new StringBuilder("s%d == %d".formatted(part, rule.state()));
        for (int i = 0; i < sources.size(); i++) {
            if (!rule.read().get(i).isEmpty()) {
                int source = sources.get(i);
                String name = source < 0 ? "e" + (-1 - source) : "o" + source;
                String any =
                        rule.read().get(i).stream()
                                .map(value -> name + " == " + value)
                                .collect(Collectors.joining(" || "));
                text.append(" && (%s)".formatted(any));
            }
        }
        return text.toString();
    }

    private static String sights(List<ComposedSystem.Sight> all) {
        return all.stream()
                .map(sight -> "o%d == %d".formatted(sight.part(), sight.value()))
                .collect(Collectors.joining(" && "));
    }
}
