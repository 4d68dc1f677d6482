package arcomat.check.walk;

import arcomat.check.law.Check.Findings;
import arcomat.source.Diagnostic;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What is found in the configurations of one component. It is told once, and where not all have it,
 * with one that has.
 */
final class ConfigurationFindings {
    private final List<Findings> laws;
    private final List<Integer> before;
    private final List<Map<Diagnostic, List<String>>> found = new ArrayList<>();
    private int configurations;

    /**
     * @param laws with what they have found elsewhere
     */
    ConfigurationFindings(List<Findings> laws) {
        this.laws = laws;
        this.before = laws.stream().map(each -> each.diagnostics().size()).toList();
        laws.forEach(each -> found.add(new LinkedHashMap<>()));
    }

    /** All that is new was found in this configuration. */
    void in(ComponentSymbol configuration) {
        String name = configuration.name() + configuration.declaration().configuration().text();
        configurations++;
        for (int i = 0; i < laws.size(); i++) {
            Map<Diagnostic, List<String>> places = found.get(i);
            laws.get(i).takeSince(before.get(i)).stream()
                    .distinct()
                    .forEach(
                            each -> places.computeIfAbsent(each, d -> new ArrayList<>()).add(name));
        }
    }

    /** Gives all findings back. */
    void tell() {
        for (int i = 0; i < laws.size(); i++) {
            Findings law = laws.get(i);
            found.get(i).forEach((finding, where) -> law.give(told(finding, where)));
        }
    }

    private Diagnostic told(Diagnostic finding, List<String> where) {
        if (where.size() == configurations) {
            return finding;
        }
        String others =
                where.size() == 1
                        ? ""
                        : " and %d other%s"
                                .formatted(where.size() - 1, where.size() == 2 ? "" : "s");
        return finding.withMessage(
                "%s (in %s%s)".formatted(finding.message(), where.get(0), others));
    }
}
