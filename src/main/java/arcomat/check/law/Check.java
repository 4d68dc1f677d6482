package arcomat.check.law;

import arcomat.source.ArrayNames;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Nearest;
import arcomat.source.Severity;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.tree.Block;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Node;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Looks whether a {@link Law} is broken. A check implements the interfaces of the things that it
 * wants to see; one walk over the workspace shows each thing to the checks that asked for its kind,
 * once and where it is declared, not where it is inherited. A check has no state: what it needs to
 * know beyond the thing is in the context, and what it finds goes into the findings; both are
 * members here, and so in sight of every check.
 */
public interface Check {

    /** Called once, for laws about all files together. */
    interface OnWorkspace extends Check {
        void check(Workspace workspace, Findings findings);
    }

    interface OnUnit extends Check {
        void check(Unit unit, Context context, Findings findings);
    }

    /** Called for top-level and inner components; the context's component is the visited one. */
    interface OnComponent extends Check {
        void check(ComponentSymbol component, Context context, Findings findings);
    }

    /** Called for the ports of components, and for the inputs and outputs of automata. */
    interface OnPort extends Check {
        void check(PortSymbol port, Context context, Findings findings);
    }

    interface OnInstance extends Check {
        void check(InstanceSymbol instance, Context context, Findings findings);
    }

    /**
     * Called for the parts of a component, each with those of its ports at which no connector ends;
     * with none where that cannot be told.
     */
    interface OnOpenPorts extends Check {
        void check(InstanceSymbol part, List<PortSymbol> open, Context context, Findings findings);
    }

    /** Called where a component is named: as a part, or as what is extended. */
    interface OnComponentUse extends Check {
        void check(ComponentUse use, Context context, Findings findings);
    }

    /** Called for the connectors that are written in a component, once for each target. */
    interface OnConnector extends Check {
        void check(ConnectorSymbol connector, Context context, Findings findings);
    }

    interface OnAutomaton extends Check {
        void check(AutomatonSymbol automaton, Context context, Findings findings);
    }

    interface OnTransition extends Check {
        void check(TransitionSymbol transition, Context context, Findings findings);
    }

    /**
     * Called for the blocks of transitions and initial states; the context knows the side. Calls
     * and increments are in the block, but not among the items.
     */
    interface OnBlock extends Check {
        void check(Block block, List<ItemSymbol> items, Context context, Findings findings);
    }

    /**
     * Called for the statements of transitions and initial states; the context knows the side.
     * Assignments in them are items as well.
     */
    interface OnActions extends Check {
        void check(ActionSymbol actions, Context context, Findings findings);
    }

    interface OnItem extends Check {
        void check(ItemSymbol item, Context context, Findings findings);
    }

    /**
     * Called for every expression as a whole, with the problems of its parts: guards, item values,
     * initial values, arguments, messages of tests.
     */
    interface OnExpression extends Check {
        void check(Typed expression, Context context, Findings findings);
    }

    /** Called for every value that stands where a type is declared, with that type. */
    interface OnValue extends Check {
        void check(Typed value, TypeSymbol type, Context context, Findings findings);
    }

    /** Called for every message type as written, also as the type argument of a component. */
    interface OnType extends Check {
        void check(TypeReference type, Context context, Findings findings);
    }

    /** Called for variables of components and of automata. */
    interface OnVariable extends Check {
        void check(VariableSymbol variable, Context context, Findings findings);
    }

    /** Called for every stereotype. */
    interface OnStereotype extends Check {
        void check(Stereotype stereotype, Carrier carrier, Context context, Findings findings);
    }

    /**
     * Called behind a file with imports, with every name in it that an import may explain: of
     * types, of components, and those in expressions.
     */
    interface OnNames extends Check {
        void check(List<QualifiedName> names, Context context, Findings findings);
    }

    interface OnClassDiagram extends Check {
        void check(DiagramSymbol diagram, Context context, Findings findings);
    }

    interface OnClass extends Check {
        void check(ClassSymbol symbol, Context context, Findings findings);
    }

    interface OnEnum extends Check {
        void check(ClassDiagram.EnumDefinition definition, Context context, Findings findings);
    }

    interface OnTestSuite extends Check {
        void check(TestSuiteSymbol suite, Context context, Findings findings);
    }

    interface OnStreamTest extends Check {
        void check(StreamTestSymbol test, Context context, Findings findings);
    }

    /**
     * A place where a component is named.
     *
     * @param name as written; of an inner component with an instance name, that name
     * @param arguments for its type parameters, as written
     */
    record ComponentUse(
            ComponentReference reference, QualifiedName name, List<TypeArgument> arguments) {}

    /**
     * Where the walk is.
     *
     * @param component the innermost component around the thing; empty in files about other things
     * @param automaton the automaton around it
     * @param transition the transition around it
     * @param side the side of the block or of the table row around it
     */
    record Context(
            Workspace workspace,
            Profile profile,
            Unit unit,
            Optional<ComponentSymbol> component,
            Optional<AutomatonSymbol> automaton,
            Optional<TransitionSymbol> transition,
            Optional<ItemSymbol.Side> side) {

        public static Context of(Workspace workspace, Profile profile, Unit unit) {
            return new Context(
                    workspace,
                    profile,
                    unit,
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty());
        }

        public Context in(ComponentSymbol inner) {
            return new Context(
                    workspace, profile, unit, Optional.of(inner), automaton, transition, side);
        }

        public Context in(AutomatonSymbol inner) {
            return new Context(
                    workspace, profile, unit, component, Optional.of(inner), transition, side);
        }

        public Context in(TransitionSymbol inner) {
            return new Context(
                    workspace, profile, unit, component, automaton, Optional.of(inner), side);
        }

        public Context in(ItemSymbol.Side inner) {
            return new Context(
                    workspace, profile, unit, component, automaton, transition, Optional.of(inner));
        }

        /** What the names of the file reach. */
        public UnitScope scope() {
            return workspace.scope(unit);
        }

        /** What a message type means here: type parameters of the component come first. */
        public Resolution<TypeSymbol> resolve(TypeReference type) {
            return component.isPresent() ? component.get().resolveType(type) : scope().type(type);
        }
    }

    /** Collects what one check finds, under the code and the severity of its law. */
    final class Findings {
        private final String code;
        private final Severity severity;
        private final List<Diagnostic> diagnostics = new ArrayList<>();

        public Findings(String code, Severity severity) {
            this.code = code;
            this.severity = severity;
        }

        /**
         * Reports a finding. The message names the thing and says what to do; it starts with a
         * small letter, puts names in single quotes and ends without a full stop.
         *
         * @param values what stands in the message for each {@code %s}; without any, the message is
         *     the text itself
         */
        public Findings report(Node place, String message, Object... values) {
            return report(place.span(), message, values);
        }

        public Findings report(Span place, String message, Object... values) {
            String text =
                    values.length == 0 ? message : String.format(Locale.ROOT, message, values);
            diagnostics.add(
                    new Diagnostic(code, severity, place, text, List.of(), Optional.empty()));
            return this;
        }

        /**
         * Reports a name that nothing has. If one of the candidates is close, the message asks for
         * it and a fix puts it in place.
         *
         * @param otherwise what to do where none is close
         */
        public Findings reportUnknown(
                Span place,
                String message,
                String name,
                Collection<String> candidates,
                String otherwise) {
            Optional<String> ofArray = ArrayNames.hint(name, candidates);
            if (ofArray.isPresent()) {
                return report(place, message + ofArray.get());
            }
            Optional<String> nearest = Nearest.to(name, candidates);
            if (nearest.isEmpty()) {
                return report(place, "%s; %s", message, otherwise);
            }
            report(place, "%s; did you mean '%s'?", message, nearest.get());
            String title = "Replace '" + name + "' by '" + nearest.get() + "'";
            return fix(Fix.replace(title, place, nearest.get()));
        }

        /** Adds a related place to the latest finding. */
        public Findings related(Node place, String note) {
            return related(place.span(), note);
        }

        public Findings related(Span place, String note) {
            return replaceLatest(latest().withRelated(place, note));
        }

        /** Adds a safe repair to the latest finding. */
        public Findings fix(Fix fix) {
            return replaceLatest(latest().withFix(fix));
        }

        public void addAll(Findings other) {
            diagnostics.addAll(other.diagnostics);
        }

        /** Takes back what was found since there were so many findings, in their order. */
        public List<Diagnostic> takeSince(int count) {
            List<Diagnostic> since = diagnostics.subList(count, diagnostics.size());
            List<Diagnostic> taken = List.copyOf(since);
            since.clear();
            return taken;
        }

        /** Adds what was found and taken back, perhaps with more words. */
        public void give(Diagnostic diagnostic) {
            diagnostics.add(diagnostic);
        }

        public List<Diagnostic> diagnostics() {
            return diagnostics;
        }

        private Diagnostic latest() {
            return diagnostics.get(diagnostics.size() - 1);
        }

        private Findings replaceLatest(Diagnostic diagnostic) {
            diagnostics.set(diagnostics.size() - 1, diagnostic);
            return this;
        }
    }
}
