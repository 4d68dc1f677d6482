package arcomat.check.walk;

import arcomat.check.law.Check;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;

import java.util.ArrayList;
import java.util.List;

/** The checks of one run, sorted by what they look at, each with the list of its findings. */
public final class Listeners {

    record Listener<C extends Check>(C check, Findings findings) {}

    private final List<Listener<Check>> all;
    final List<Listener<Check.OnWorkspace>> onWorkspace;
    final List<Listener<Check.OnUnit>> onUnit;
    final List<Listener<Check.OnComponent>> onComponent;
    final List<Listener<Check.OnPort>> onPort;
    final List<Listener<Check.OnInstance>> onInstance;
    final List<Listener<Check.OnAutomaton>> onAutomaton;
    final List<Listener<Check.OnState>> onState;
    final List<Listener<Check.OnInitial>> onInitial;
    final List<Listener<Check.OnTransition>> onTransition;
    final List<Listener<Check.OnBlock>> onBlock;
    final List<Listener<Check.OnItem>> onItem;
    final List<Listener<Check.OnTable>> onTable;
    final List<Listener<Check.OnExpression>> onExpression;
    final List<Listener<Check.OnType>> onType;
    final List<Listener<Check.OnVariable>> onVariable;
    final List<Listener<Check.OnStereotypes>> onStereotypes;
    final List<Listener<Check.OnNames>> onNames;
    final List<Listener<Check.OnClassDiagram>> onClassDiagram;
    final List<Listener<Check.OnTestSuite>> onTestSuite;
    final List<Listener<Check.OnStreamTest>> onStreamTest;

    /** The checks whose laws hold in a profile. */
    public Listeners(List<Check> checks, Profile profile) {
        all = new ArrayList<>();
        for (Check check : checks) {
            Law law = check.law();
            law.severity(profile)
                    .ifPresent(
                            severity ->
                                    all.add(
                                            new Listener<>(
                                                    check, new Findings(law.code(), severity))));
        }
        onWorkspace = those(Check.OnWorkspace.class);
        onUnit = those(Check.OnUnit.class);
        onComponent = those(Check.OnComponent.class);
        onPort = those(Check.OnPort.class);
        onInstance = those(Check.OnInstance.class);
        onAutomaton = those(Check.OnAutomaton.class);
        onState = those(Check.OnState.class);
        onInitial = those(Check.OnInitial.class);
        onTransition = those(Check.OnTransition.class);
        onBlock = those(Check.OnBlock.class);
        onItem = those(Check.OnItem.class);
        onTable = those(Check.OnTable.class);
        onExpression = those(Check.OnExpression.class);
        onType = those(Check.OnType.class);
        onVariable = those(Check.OnVariable.class);
        onStereotypes = those(Check.OnStereotypes.class);
        onNames = those(Check.OnNames.class);
        onClassDiagram = those(Check.OnClassDiagram.class);
        onTestSuite = those(Check.OnTestSuite.class);
        onStreamTest = those(Check.OnStreamTest.class);
    }

    private <C extends Check> List<Listener<C>> those(Class<C> kind) {
        List<Listener<C>> chosen = new ArrayList<>();
        for (Listener<Check> listener : all) {
            if (kind.isInstance(listener.check())) {
                chosen.add(new Listener<>(kind.cast(listener.check()), listener.findings()));
            }
        }
        return chosen;
    }

    /** Adds what the same checks found elsewhere. */
    void addAll(Listeners other) {
        for (int i = 0; i < all.size(); i++) {
            all.get(i).findings().addAll(other.all.get(i).findings());
        }
    }

    /** What every check has found so far. */
    List<Findings> findings() {
        List<Findings> found = new ArrayList<>();
        for (Listener<Check> listener : all) {
            found.add(listener.findings());
        }
        return found;
    }
}
