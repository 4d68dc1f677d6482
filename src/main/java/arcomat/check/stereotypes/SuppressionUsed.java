package arcomat.check.stereotypes;

import arcomat.check.law.Check;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.law.Suppressions.Suppression;
import arcomat.source.Severity;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * ARC0507: a suppression suppresses something. Asked when all other checks are done, since only
 * then is known what there was to suppress.
 */
public final class SuppressionUsed implements Check {
    public static final String CODE = "ARC0507";

    /**
     * Reports suppressions of laws that hold in a profile but are not broken there. Laws about all
     * files together are not judged, since some files may not be looked at, and neither is what
     * analyses find, since this room does not know that.
     *
     * @param used those that did suppress something
     * @param laws all that there are
     */
    public static Findings unused(
            Suppressions all, Collection<Suppression> used, List<Law> laws, Profile profile) {
        Findings findings = new Findings(CODE, Severity.WARNING);
        Set<Suppression> idle = new LinkedHashSet<>(all.all());
        idle.removeAll(used);
        if (idle.isEmpty()) {
            return findings; // as nearly always
        }
        Set<String> judged =
                laws.stream()
                        .filter(law -> isJudged(law) && law.severity(profile).isPresent())
                        .map(Law::code)
                        .collect(Collectors.toSet());
        for (Suppression each : idle) {
            if (judged.contains(each.code())) {
                findings.report(
                        each.place(),
                        "there is no finding %s here to suppress; delete the suppression",
                        each.code());
            }
        }
        return findings;
    }

    private static boolean isJudged(Law law) {
        return !(law.check() instanceof Check.OnWorkspace)
                && !law.code().equals(CODE)
                && !SuppressWellFormed.isOfAnalysis(law.code());
    }
}
