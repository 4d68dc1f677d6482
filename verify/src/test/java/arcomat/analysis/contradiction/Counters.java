package arcomat.analysis.contradiction;

import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Map;

/**
 * Requirements that count: each has an input of its own, and when that has come often enough, it
 * has a say in the output that they share. All but two of them leave each other room. Together they
 * are in more configurations than can be looked at.
 */
final class Counters {
    private Counters() {}

    /**
     * @param levels from 1, what a counter may ask for
     * @param refused by the position of a counter, the level that it does not want in the end
     */
    static Promise of(int counters, int levels, Map<Integer, Integer> refused) {
        StringBuilder ports = new StringBuilder();
        StringBuilder automata = new StringBuilder();
        for (int i = 0; i < counters; i++) {
            int last = 6 + i % 5;
            ports.append("in Boolean tick").append(i).append(", ");
            automata.append("  <<completion = \"output\">> automaton counter%d {\n".formatted(i));
            automata.append("    variable Integer[0..%d] n = 0;\n".formatted(last));
            automata.append("    state s;\n    initial s / {level = 1};\n");
            automata.append(
                    "    s [n < %d] {tick%d == true} / {n = n + 1, level = --};\n"
                            .formatted(last, i));
            for (int level = 1; level <= levels; level++) {
                automata.append(
                        "    s [n < %d] {tick%d == true} / {n = n + 1, level = %d};\n"
                                .formatted(last, i, level));

                if (level != refused.getOrDefault(i, 0)) {
                    automata.append(
                            "    s [n == %d] {tick%d == true} / {n = 0, level = %d};\n"
                                    .formatted(last, i, level));
                }
            }
            automata.append("  }\n");
        }
        String text =
                "component Counters {\n  port %sout Integer[0..9] level;\n%s}\n"
                        .formatted(ports, automata);
        SourceFile file = new SourceFile("Counters.arc", text);
        return Promise.of(ReadModels.model(file).component("Counters").orElseThrow(), List.of());
    }
}
