package arcomat.check.walk;

import arcomat.check.law.Check;
import arcomat.check.law.Check.Findings;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/** The checks of one run, sorted by what they look at, each with the list of its findings. */
public final class Listeners {

    /** A check, and what it has found. */
    record Listener<C extends Check>(C check, Findings findings) {}

    /** The checks that look at things of one kind, picked when the first such thing is met. */
    static final class Audience<C extends Check> implements Iterable<Listener<C>> {
        private final Class<C> kind;
        private final List<Listener<Check>> all;
        private @Nullable List<Listener<C>> own;

        private Audience(Class<C> kind, List<Listener<Check>> all) {
            this.kind = kind;
            this.all = all;
        }

        @Override
        public Iterator<Listener<C>> iterator() {
            if (own == null) {
                own = new ArrayList<>();
                for (Listener<Check> each : all) {
                    if (kind.isInstance(each.check())) {
                        own.add(new Listener<>(kind.cast(each.check()), each.findings()));
                    }
                }
            }
            return own.iterator();
        }
    }

    private final List<Listener<Check>> all = new ArrayList<>();

    final Audience<Check.OnWorkspace> onWorkspace = audience(Check.OnWorkspace.class);
    final Audience<Check.OnUnit> onUnit = audience(Check.OnUnit.class);
    final Audience<Check.OnComponent> onComponent = audience(Check.OnComponent.class);
    final Audience<Check.OnPort> onPort = audience(Check.OnPort.class);
    final Audience<Check.OnInstance> onInstance = audience(Check.OnInstance.class);
    final Audience<Check.OnOpenPorts> onOpenPorts = audience(Check.OnOpenPorts.class);
    final Audience<Check.OnComponentUse> onComponentUse = audience(Check.OnComponentUse.class);
    final Audience<Check.OnConnector> onConnector = audience(Check.OnConnector.class);
    final Audience<Check.OnAutomaton> onAutomaton = audience(Check.OnAutomaton.class);
    final Audience<Check.OnTransition> onTransition = audience(Check.OnTransition.class);
    final Audience<Check.OnBlock> onBlock = audience(Check.OnBlock.class);
    final Audience<Check.OnActions> onActions = audience(Check.OnActions.class);
    final Audience<Check.OnItem> onItem = audience(Check.OnItem.class);
    final Audience<Check.OnValue> onValue = audience(Check.OnValue.class);
    final Audience<Check.OnExpression> onExpression = audience(Check.OnExpression.class);
    final Audience<Check.OnType> onType = audience(Check.OnType.class);
    final Audience<Check.OnVariable> onVariable = audience(Check.OnVariable.class);
    final Audience<Check.OnStereotype> onStereotype = audience(Check.OnStereotype.class);
    final Audience<Check.OnNames> onNames = audience(Check.OnNames.class);
    final Audience<Check.OnClassDiagram> onClassDiagram = audience(Check.OnClassDiagram.class);
    final Audience<Check.OnClass> onClass = audience(Check.OnClass.class);
    final Audience<Check.OnEnum> onEnum = audience(Check.OnEnum.class);
    final Audience<Check.OnTestSuite> onTestSuite = audience(Check.OnTestSuite.class);
    final Audience<Check.OnStreamTest> onStreamTest = audience(Check.OnStreamTest.class);

    /** The checks whose laws hold in a profile. */
    public Listeners(List<Law> laws, Profile profile) {
        for (Law law : laws) {
            law.severity(profile)
                    .map(severity -> new Findings(law.code(), severity))
                    .ifPresent(own -> all.add(new Listener<>(law.check(), own)));
        }
    }

    private <C extends Check> Audience<C> audience(Class<C> kind) {
        return new Audience<>(kind, all);
    }

    /** Adds what the same checks found elsewhere. */
    void addAll(Listeners other) {
        for (int i = 0; i < all.size(); i++) {
            all.get(i).findings().addAll(other.all.get(i).findings());
        }
    }

    /** What every check has found so far. */
    List<Findings> findings() {
        return all.stream().map(Listener::findings).toList();
    }
}
