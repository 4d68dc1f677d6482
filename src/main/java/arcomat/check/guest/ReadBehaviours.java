package arcomat.check.guest;

import arcomat.check.language.ToldByLanguage;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.check.walk.Listeners;
import arcomat.check.walk.Walk;
import arcomat.source.Diagnostic;
import arcomat.symbols.Workspace;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * What guests have found wrong with behaviours in their languages when names and types were known.
 * Their codes are asked like laws, so that configurations and suppressions are as for those.
 */
public record ReadBehaviours(List<String> codes) {
    /** ARC1203: a behaviour is not as its language wants it. ARC1204: a guest fails at one. */
    private static final List<String> OF_ANY_LANGUAGE = List.of("ARC1203", "ARC1204");

    public ReadBehaviours {
        codes = List.copyOf(codes);
    }

    /** Of all guests that have such languages. */
    public static ReadBehaviours by(List<GuestLaws> guests) {
        List<GuestLaws> readers =
                guests.stream().filter(each -> each.reader() != BehaviourReader.NONE).toList();
        if (readers.isEmpty()) {
            return new ReadBehaviours(List.of());
        }
        Stream<String> own = readers.stream().flatMap(each -> each.others().stream());
        return new ReadBehaviours(Stream.concat(OF_ANY_LANGUAGE.stream(), own).toList());
    }

    /**
     * The findings.
     *
     * @param wanted files to look at
     * @param goOn asked before each step; what it throws ends the work
     */
    public List<Diagnostic> findings(
            Workspace workspace, Profile profile, Predicate<Unit> wanted, Runnable goOn) {
        if (codes.isEmpty()) {
            return List.of();
        }
        List<Law> laws =
                codes.stream()
                        .map(each -> Law.error(each, new ToldByLanguage(each, each)))
                        .toList();
        Walk walk = new Walk(workspace, profile, new Listeners(laws, profile));
        for (Consumer<Walk> step : Walk.steps(workspace, wanted)) {
            goOn.run();
            step.accept(walk);
        }
        List<Diagnostic> all = new ArrayList<>();
        walk.findings().forEach(each -> all.addAll(each.diagnostics()));
        return all;
    }
}
