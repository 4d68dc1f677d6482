package arcomat.check;

import arcomat.check.Suppressions.Suppression;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;
import arcomat.symbols.Outline;
import arcomat.symbols.Workspace;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collector;
import java.util.stream.Stream;

/** The list of all context conditions, and the one way to run them. */
public final class Checks {
    /** One line per law, in alphabetical order. */
    static final List<Check> ALL =
            List.of(
                    new AnyMessageOnOutput(),
                    new ArgumentCount(),
                    new ArgumentType(),
                    new AttributesUnique(),
                    new AutomataNamesUnique(),
                    new BehaviourPresent(),
                    new ClassContainsItself(),
                    new ClassInheritanceAcyclic(),
                    new ClauseUnique(),
                    new ComparedWithItself(),
                    new ComponentExists(),
                    new ComponentNameIsFileName(),
                    new ComponentVariableConstant(),
                    new ConnectorDirection(),
                    new ConnectorEndExists(),
                    new ConnectorEndForm(),
                    new ConnectorTypes(),
                    new DefaultParametersLast(),
                    new DelayInCycle(),
                    new DiagramTypesUnique(),
                    new DivisionByZeroLiteral(),
                    new EmbeddedAutomatonInterface(),
                    new EnumConstantsUnique(),
                    new EnumFitsClass(),
                    new EnumNotEmpty(),
                    new EventsForUntimedOnly(),
                    new FileNamesDifferInCaseOnly(),
                    new FirstValueFits(),
                    new GuardIsBoolean(),
                    new IgnoreExcludesTotalOutput(),
                    new ImportResolves(),
                    new ImportUnique(),
                    new ImportUsed(),
                    new InheritanceAcyclic(),
                    new InheritedPortUnchanged(),
                    new InitialDeclaredOnce(),
                    new InitialOutputDelayed(),
                    new InitialReadsNoInput(),
                    new InitialRequired(),
                    new InitialValueFits(),
                    new InnerComponentNamesUnique(),
                    new InputSideReads(),
                    new InvariantNamesUnique(),
                    new InvariantUnevaluated(),
                    new ItemNameExists(),
                    new ItemOncePerBlock(),
                    new ItemTypeFits(),
                    new JavaClassUnique(),
                    new JavaPartUnsupported(),
                    new LayerOrder(),
                    new LiteralFits(),
                    new LiteralInRange(),
                    new LogicWithoutPlatform(),
                    new MemberNamesUnique(),
                    new NameExists(),
                    new NoAlternativesOnOutput(),
                    new NoSequenceOnVariable(),
                    new NoSilenceOnVariable(),
                    new OmittedNameUnique(),
                    new OperandTypes(),
                    new OutputPortNotRead(),
                    new OutputSideWrites(),
                    new OwnPortConnected(),
                    new PackageIsFolder(),
                    new PartsCountable(),
                    new PortConnectedToItself(),
                    new PortNameUncapitalised(),
                    new PortUniqueSender(),
                    new ProfilesNotMixed(),
                    new RangeWellFormed(),
                    new RefinesExists(),
                    new RefinesInterface(),
                    new RefinesOther(),
                    new SingleAutomaton(),
                    new SingleEvent(),
                    new SingleInitial(),
                    new SingleMessagePerSlice(),
                    new StateDeclaredOnce(),
                    new StateExists(),
                    new StateNamesCapitalisedAlike(),
                    new StateReached(),
                    new StateRequired(),
                    new StereotypeInPlace(),
                    new StereotypeKnown(),
                    new StereotypeValue(),
                    new SubcomponentAcyclic(),
                    new SubcomponentInputConnected(),
                    new SubcomponentPortConnected(),
                    new SuperClassIsClass(),
                    new SupportedExpression(),
                    new SupportedItem(),
                    new SuppressWellFormed(),
                    new SuppressionUsed(),
                    new TableCellFits(),
                    new TableColumnsExist(),
                    new TableRowWidth(),
                    new TestArguments(),
                    new TestFieldUnsupported(),
                    new TestMessageType(),
                    new TestNamesUnique(),
                    new TestPortExists(),
                    new TestSingleMessagePerSlice(),
                    new TestStreamLength(),
                    new TestStreamOnce(),
                    new TestedComponentExists(),
                    new TopLevelComponentWithoutInstance(),
                    new TotalInputHasTotalSender(),
                    new TotalInputNeverSilent(),
                    new TotalOutputNamed(),
                    new TotalPortTimed(),
                    new TransitionsApart(),
                    new TypeArgumentsComplete(),
                    new TypeArgumentsInBounds(),
                    new TypeExists(),
                    new TypeNameCapitalised(),
                    new TypeParametersUnique(),
                    new VariableDeclaredOnce(),
                    new VariableUnlikePort());

    /** With fewer definitions one thread is done before a second one has started. */
    private static final int WORTH_A_SECOND_THREAD = 200;

    private Checks() {}

    /** Of every check: its code, and how bad it is to break it. */
    public static List<Law> laws() {
        return ALL.stream().map(Check::law).toList();
    }

    /** The findings about all files of a workspace, ordered, each once. */
    public static List<Diagnostic> run(Workspace workspace, Profile profile) {
        return review(workspace, profile).findings();
    }

    /** The findings, and those that the models declare to be meant. */
    public static Review review(Workspace workspace, Profile profile) {
        return review(workspace, profile, unit -> true);
    }

    /** As above, but only about some of the files. */
    public static Review review(Workspace workspace, Profile profile, Predicate<Unit> wanted) {
        return review(workspace, profile, wanted, () -> {});
    }

    /**
     * As above, for somebody who may not want to wait.
     *
     * @param wanted files to look at; findings of laws about all files together may be about others
     * @param goOn asked before each step; it may throw what ends the work
     */
    public static Review review(
            Workspace workspace, Profile profile, Predicate<Unit> wanted, Runnable goOn) {
        List<Consumer<Walk>> steps = Walk.steps(workspace, wanted);
        Stream<Consumer<Walk>> stream =
                steps.size() > WORTH_A_SECOND_THREAD ? steps.parallelStream() : steps.stream();
        Walk walk =
                stream.collect(
                        Collector.of(
                                () -> new Walk(workspace, profile, new Listeners(ALL, profile)),
                                (each, step) -> {
                                    goOn.run();
                                    step.accept(each);
                                },
                                Walk::join));
        List<Diagnostic> found =
                walk.findings().stream().flatMap(each -> each.diagnostics().stream()).toList();
        Suppressions suppressions = walk.suppressions();
        Set<Suppression> used = new HashSet<>();
        found.forEach(finding -> used.addAll(suppressions.covering(finding)));
        List<Diagnostic> all = new ArrayList<>(found);
        if (workspace.isComplete()) {
            all.addAll(new SuppressionUsed().unused(suppressions, used, profile).diagnostics());
        }
        return sort(all, suppressions, profile);
    }

    /**
     * The findings about the parts that could be read of files with syntax errors, as far as they
     * do not come from what could not be read.
     *
     * @param files what could be read of them
     * @param units the files that parse
     * @param brokenFiles paths of those that do not
     * @param others outlines of files that are not looked at
     */
    public static Review reviewRecovered(
            List<Recovered> files,
            List<Unit> units,
            Set<String> brokenFiles,
            List<Outline> others,
            Profile profile) {
        if (files.isEmpty()) {
            return new Review(List.of(), List.of());
        }
        List<Unit> parts = files.stream().map(Recovered::unit).toList();
        Workspace around = Workspace.around(parts, units, brokenFiles, others);
        Map<String, Recovery> recoveries = new HashMap<>();
        files.forEach(each -> recoveries.put(each.unit().file().path(), new Recovery(each)));
        Predicate<Diagnostic> sure =
                finding ->
                        Optional.ofNullable(recoveries.get(finding.span().file().path()))
                                .filter(recovery -> recovery.isSure(finding))
                                .isPresent();
        Review all = review(around, profile, unit -> recoveries.containsKey(unit.file().path()));
        return new Review(
                all.findings().stream().filter(sure).toList(),
                all.suppressed().stream().filter(each -> sure.test(each.finding())).toList());
    }

    /** Findings that others made: those that the models declare to be meant are told apart. */
    public static Review sort(Workspace workspace, List<Diagnostic> findings) {
        Listeners nobody = new Listeners(List.of(), Profile.REQUIREMENTS);
        Walk walk = new Walk(workspace, Profile.REQUIREMENTS, nobody);
        Walk.steps(workspace, unit -> true).forEach(step -> step.accept(walk));
        return sort(findings, walk.suppressions(), Profile.REQUIREMENTS);
    }

    /** Whether a finding is about a suppression that suppresses nothing. */
    public static boolean isUnusedSuppression(Diagnostic finding) {
        return finding.code().equals(SuppressionUsed.LAW.code());
    }

    private static Review sort(
            Collection<Diagnostic> found, Suppressions suppressions, Profile profile) {
        TreeSet<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        all.addAll(found);
        List<Diagnostic> findings = new ArrayList<>();
        List<Suppressed> suppressed = new ArrayList<>();
        for (Diagnostic finding : all) {
            List<Suppression> meant =
                    maySuppress(finding, profile) ? suppressions.covering(finding) : List.of();
            if (meant.isEmpty()) {
                findings.add(finding);
            } else {
                suppressed.add(new Suppressed(finding, meant.get(0).reason()));
            }
        }
        return new Review(findings, suppressed);
    }

    /** No code is made from a model with errors, whoever meant them. */
    private static boolean maySuppress(Diagnostic finding, Profile profile) {
        return profile == Profile.REQUIREMENTS || !finding.isError();
    }
}
