package arcomat.check.stereotypes;

import arcomat.check.law.Check;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.law.Suppressions.Suppression;
import arcomat.source.Severity;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;

/**
 * ARC0507: a suppression suppresses something. Asked when all other checks are done, since only
 * then is known what there was to suppress.
 */
public final class SuppressionUsed implements Check {
    public static final Law LAW = Law.warning("ARC0507");

    private final Supplier<List<Check>> checks;

    /**
     * @param checks all of them, this one included
     */
    public SuppressionUsed(Supplier<List<Check>> checks) {
        this.checks = checks;
    }

    @Override
    public Law law() {
        return LAW;
    }

    /**
     * Reports suppressions of laws that hold in a profile but are not broken there. Laws about all
     * files together are not judged, since some files may not be looked at, and neither is what
     * analyses find, since this room does not know that.
     *
     * @param used those that did suppress something
     */
    public Findings unused(Suppressions all, Collection<Suppression> used, Profile profile) {
        Findings findings = new Findings(law().code(), Severity.WARNING);
        Set<String> judged = judged(profile);
        List<Suppression> idle = all.all().stream().filter(each -> !used.contains(each)).toList();
        for (Suppression each : idle) {
            if (judged.contains(each.code())) {
                findings.report(
                        each.place(),
                        "there is no finding %s here to suppress; delete the suppression"
                                .formatted(each.code()));
            }
        }
        return findings;
    }

    private Set<String> judged(Profile profile) {
        Set<String> judged = new TreeSet<>();
        for (Check check : checks.get()) {
            if (!(check instanceof Check.OnWorkspace)) {
                check.law().severity(profile).ifPresent(s -> judged.add(check.law().code()));
            }
        }
        judged.remove(law().code());
        judged.removeIf(SuppressWellFormed::isOfAnalysis);
        return judged;
    }
}
