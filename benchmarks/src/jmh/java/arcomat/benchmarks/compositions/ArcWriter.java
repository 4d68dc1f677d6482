package arcomat.benchmarks.compositions;

import arcomat.benchmarks.compositions.PartKind.Rule;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A system as a model: an invariant says what is forbidden. */
final class ArcWriter {
    private ArcWriter() {}

    /** One text per component, the whole last. */
    static List<String> texts(ComposedSystem system) {
        List<String> texts = new ArrayList<>();
        system.kinds().forEach(kind -> texts.add(text(kind)));
        texts.add(whole(system));
        return texts;
    }

    private static String text(PartKind kind) {
        List<String> ports = new ArrayList<>();
        for (int i = 0; i < kind.inputs().size(); i++) {
            ports.add("in Integer[0..%d] i%d".formatted(kind.inputs().get(i) - 1, i));
        }
        ports.add("out Integer[0..%d] o".formatted(kind.values() - 1));
        String states =
                IntStream.range(0, kind.states())
                        .mapToObj(state -> "s" + state)
                        .collect(Collectors.joining(", "));
        List<String> transitions = new ArrayList<>();
        for (Rule rule : kind.rules()) {
            for (PartKind.Way way : rule.ways()) {
                transitions.add(
                        "s%d -> s%d %s / {o = %d};"
                                .formatted(rule.state(), way.state(), read(rule), way.sends()));
            }
        }
        return """
        package load;
        component %s {
          port <<total>> %s;
          <<completion = "ignore">> automaton {
            state %s;
            initial s0 / {o = %d};
            %s
          }
        }
        """
                .formatted(
                        kind.name(),
                        String.join(", <<total>> ", ports),
                        states,
                        kind.first(),
                        String.join("\n    ", transitions));
    }

    private static String read(Rule rule) {
        String items =
                IntStream.range(0, rule.read().size())
                        .filter(i -> !rule.read().get(i).isEmpty())
                        .mapToObj(i -> item(i, rule.read().get(i)))
                        .collect(Collectors.joining(", "));
        return items.isEmpty() ? "" : "{" + items + "}";
    }

    private static String item(int port, List<Integer> values) {
        String all = values.stream().map(String::valueOf).collect(Collectors.joining(", "));
        return values.size() == 1
                ? "i%d == %s".formatted(port, all)
                : "i%d == alt {%s}".formatted(port, all);
    }

    private static String whole(ComposedSystem system) {
        StringBuilder text = new StringBuilder("package load;\ncomponent Whole {\n");
        for (int i = 0; i < system.externals(); i++) {
            text.append("  port <<total>> in Integer[0..1] e%d;%n".formatted(i));
        }
        for (int p = 0; p < system.parts().size(); p++) {
            ComposedSystem.Part part = system.parts().get(p);
            text.append("  component %s p%d;%n".formatted(system.kind(part).name(), p));
            for (int i = 0; i < part.sources().size(); i++) {
                int source = part.sources().get(i);
                String from = source < 0 ? "e" + (-1 - source) : "p" + source + ".o";
                text.append("  connect %s -> p%d.i%d;%n".formatted(from, p, i));
            }
        }
        String never =
                system.forbidden().stream()
                        .map(all -> "!(" + sights(all) + ")")
                        .collect(Collectors.joining(" && "));
        return text.append("  ocl inv safe: %s;%n}%n".formatted(never)).toString();
    }

    private static String sights(List<ComposedSystem.Sight> all) {
        return all.stream()
                .map(sight -> "p%d.o == %d".formatted(sight.part(), sight.value()))
                .collect(Collectors.joining(" && "));
    }
}
