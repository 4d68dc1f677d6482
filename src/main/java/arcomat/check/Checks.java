package arcomat.check;

import arcomat.check.behaviour.automaton.EmbeddedAutomatonInterface;
import arcomat.check.behaviour.automaton.GuardIsBoolean;
import arcomat.check.behaviour.automaton.InitialRequired;
import arcomat.check.behaviour.automaton.ItemOncePerBlock;
import arcomat.check.behaviour.automaton.SingleEvent;
import arcomat.check.behaviour.automaton.SingleInitial;
import arcomat.check.behaviour.automaton.StateExists;
import arcomat.check.behaviour.automaton.StateReached;
import arcomat.check.behaviour.automaton.StateRequired;
import arcomat.check.behaviour.automaton.TransitionsApart;
import arcomat.check.behaviour.expression.DivisionByZeroLiteral;
import arcomat.check.behaviour.expression.InitialReadsNoInput;
import arcomat.check.behaviour.expression.LiteralFits;
import arcomat.check.behaviour.expression.LiteralInRange;
import arcomat.check.behaviour.expression.NameExists;
import arcomat.check.behaviour.expression.OperandTypes;
import arcomat.check.behaviour.expression.OutputPortNotRead;
import arcomat.check.behaviour.expression.RangeWellFormed;
import arcomat.check.behaviour.expression.SupportedExpression;
import arcomat.check.behaviour.item.AnyMessageOnOutput;
import arcomat.check.behaviour.item.ComparedWithItself;
import arcomat.check.behaviour.item.InitialOutputDelayed;
import arcomat.check.behaviour.item.InitialValueFits;
import arcomat.check.behaviour.item.InputSideReads;
import arcomat.check.behaviour.item.ItemNameExists;
import arcomat.check.behaviour.item.ItemTypeFits;
import arcomat.check.behaviour.item.NoAlternativesOnOutput;
import arcomat.check.behaviour.item.NoSequenceOnVariable;
import arcomat.check.behaviour.item.NoSilenceOnVariable;
import arcomat.check.behaviour.item.OmittedNameUnique;
import arcomat.check.behaviour.item.OutputSideWrites;
import arcomat.check.behaviour.item.SingleMessagePerSlice;
import arcomat.check.behaviour.item.SupportedItem;
import arcomat.check.behaviour.table.TableCellFits;
import arcomat.check.behaviour.table.TableColumnsExist;
import arcomat.check.behaviour.table.TableRowWidth;
import arcomat.check.behaviour.total.FirstValueFits;
import arcomat.check.behaviour.total.IgnoreExcludesTotalOutput;
import arcomat.check.behaviour.total.TotalInputHasTotalSender;
import arcomat.check.behaviour.total.TotalInputNeverSilent;
import arcomat.check.behaviour.total.TotalOutputNamed;
import arcomat.check.behaviour.total.TotalPortTimed;
import arcomat.check.diagrams.AttributesUnique;
import arcomat.check.diagrams.ClassContainsItself;
import arcomat.check.diagrams.ClassInheritanceAcyclic;
import arcomat.check.diagrams.DiagramTypesUnique;
import arcomat.check.diagrams.EnumConstantsUnique;
import arcomat.check.diagrams.EnumFitsClass;
import arcomat.check.diagrams.EnumNotEmpty;
import arcomat.check.diagrams.SuperClassIsClass;
import arcomat.check.law.Check;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.law.Suppressions.Suppression;
import arcomat.check.naming.AutomataNamesUnique;
import arcomat.check.naming.ComponentNameIsFileName;
import arcomat.check.naming.FileNamesDifferInCaseOnly;
import arcomat.check.naming.InitialDeclaredOnce;
import arcomat.check.naming.InnerComponentNamesUnique;
import arcomat.check.naming.InvariantNamesUnique;
import arcomat.check.naming.JavaClassUnique;
import arcomat.check.naming.MemberNamesUnique;
import arcomat.check.naming.PackageIsFolder;
import arcomat.check.naming.PortNameUncapitalised;
import arcomat.check.naming.StateDeclaredOnce;
import arcomat.check.naming.StateNamesCapitalisedAlike;
import arcomat.check.naming.TypeNameCapitalised;
import arcomat.check.naming.TypeParametersUnique;
import arcomat.check.naming.VariableDeclaredOnce;
import arcomat.check.naming.VariableUnlikePort;
import arcomat.check.refinement.RefinesExists;
import arcomat.check.refinement.RefinesInterface;
import arcomat.check.refinement.RefinesOther;
import arcomat.check.stereotypes.LayerOrder;
import arcomat.check.stereotypes.LogicWithoutPlatform;
import arcomat.check.stereotypes.StereotypeInPlace;
import arcomat.check.stereotypes.StereotypeKnown;
import arcomat.check.stereotypes.StereotypeValue;
import arcomat.check.stereotypes.SuppressWellFormed;
import arcomat.check.stereotypes.SuppressionUsed;
import arcomat.check.structure.ArgumentCount;
import arcomat.check.structure.ArgumentType;
import arcomat.check.structure.BehaviourPresent;
import arcomat.check.structure.ClauseUnique;
import arcomat.check.structure.ComponentExists;
import arcomat.check.structure.ComponentVariableConstant;
import arcomat.check.structure.ConnectorDirection;
import arcomat.check.structure.ConnectorEndExists;
import arcomat.check.structure.ConnectorEndForm;
import arcomat.check.structure.ConnectorTypes;
import arcomat.check.structure.DefaultParametersLast;
import arcomat.check.structure.DelayInCycle;
import arcomat.check.structure.ImportResolves;
import arcomat.check.structure.ImportUnique;
import arcomat.check.structure.ImportUsed;
import arcomat.check.structure.InheritanceAcyclic;
import arcomat.check.structure.InheritedPortUnchanged;
import arcomat.check.structure.InvariantUnevaluated;
import arcomat.check.structure.JavaPartUnsupported;
import arcomat.check.structure.OwnPortConnected;
import arcomat.check.structure.PartsCountable;
import arcomat.check.structure.PortConnectedToItself;
import arcomat.check.structure.PortUniqueSender;
import arcomat.check.structure.ProfilesNotMixed;
import arcomat.check.structure.SingleAutomaton;
import arcomat.check.structure.SubcomponentAcyclic;
import arcomat.check.structure.SubcomponentInputConnected;
import arcomat.check.structure.SubcomponentPortConnected;
import arcomat.check.structure.TopLevelComponentWithoutInstance;
import arcomat.check.structure.TypeArgumentsComplete;
import arcomat.check.structure.TypeArgumentsInBounds;
import arcomat.check.structure.TypeExists;
import arcomat.check.tests.EventsForUntimedOnly;
import arcomat.check.tests.TestArguments;
import arcomat.check.tests.TestFieldUnsupported;
import arcomat.check.tests.TestMessageType;
import arcomat.check.tests.TestNamesUnique;
import arcomat.check.tests.TestPortExists;
import arcomat.check.tests.TestSingleMessagePerSlice;
import arcomat.check.tests.TestStreamLength;
import arcomat.check.tests.TestStreamOnce;
import arcomat.check.tests.TestedComponentExists;
import arcomat.check.walk.Listeners;
import arcomat.check.walk.Walk;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Outline;
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
    /** Asked when all others are done. */
    private static final SuppressionUsed UNUSED = new SuppressionUsed(() -> Checks.ALL);

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
                    new SuppressWellFormed(() -> Checks.ALL),
                    UNUSED,
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
            all.addAll(UNUSED.unused(suppressions, used, profile).diagnostics());
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
