package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;

/** The list of all context conditions, and the one way to run them. */
public final class Checks {
    /** One line per law, in alphabetical order. */
    static final List<Check> ALL =
            List.of(
                    new ArgumentCount(),
                    new ArgumentType(),
                    new BehaviourPresent(),
                    new ClauseUnique(),
                    new ComponentExists(),
                    new ComponentNameIsFileName(),
                    new ComponentVariableConstant(),
                    new ConnectorDirection(),
                    new ConnectorEndExists(),
                    new ConnectorEndForm(),
                    new ConnectorTypes(),
                    new DefaultParametersLast(),
                    new DelayInCycle(),
                    new FileNamesDifferInCaseOnly(),
                    new ImportResolves(),
                    new ImportUnique(),
                    new ImportUsed(),
                    new InheritanceAcyclic(),
                    new InheritedPortUnchanged(),
                    new InnerComponentNamesUnique(),
                    new JavaClassUnique(),
                    new JavaPartUnsupported(),
                    new LayerOrder(),
                    new LogicWithoutPlatform(),
                    new MemberNamesUnique(),
                    new OwnPortConnected(),
                    new PackageIsFolder(),
                    new PortConnectedToItself(),
                    new PortNameUncapitalised(),
                    new PortUniqueSender(),
                    new ProfilesNotMixed(),
                    new SingleAutomaton(),
                    new StereotypeInPlace(),
                    new StereotypeKnown(),
                    new StereotypeValue(),
                    new SubcomponentAcyclic(),
                    new SubcomponentInputConnected(),
                    new SubcomponentPortConnected(),
                    new SuppressWellFormed(),
                    new TopLevelComponentWithoutInstance(),
                    new TotalInputHasTotalSender(),
                    new TypeArgumentsComplete(),
                    new TypeArgumentsInBounds(),
                    new TypeExists(),
                    new TypeNameCapitalised(),
                    new TypeParametersUnique());

    private Checks() {}

    /** The findings about all files of a workspace, ordered, each once. */
    public static List<Diagnostic> run(Workspace workspace, Profile profile) {
        return review(workspace, profile).findings();
    }

    /** The findings, and those that the models declare to be meant. */
    public static Review review(Workspace workspace, Profile profile) {
        Listeners listeners = new Listeners(ALL, profile);
        Suppressions suppressions = new Suppressions();
        new Walk(workspace, profile, listeners, suppressions).walk();
        return sort(listeners, suppressions, profile);
    }

    private static Review sort(Listeners listeners, Suppressions suppressions, Profile profile) {
        TreeSet<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        for (Findings findings : listeners.findings()) {
            all.addAll(findings.diagnostics());
        }
        List<Diagnostic> findings = new ArrayList<>();
        List<Review.Suppressed> suppressed = new ArrayList<>();
        for (Diagnostic finding : all) {
            Optional<String> reason =
                    maySuppress(finding, profile) ? suppressions.reason(finding) : Optional.empty();
            if (reason.isPresent()) {
                suppressed.add(new Review.Suppressed(finding, reason.get()));
            } else {
                findings.add(finding);
            }
        }
        return new Review(findings, suppressed);
    }

    /** No code is made from a model with errors, whoever meant them. */
    private static boolean maySuppress(Diagnostic finding, Profile profile) {
        return profile == Profile.REQUIREMENTS || !finding.isError();
    }
}
