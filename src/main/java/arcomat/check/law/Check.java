package arcomat.check.law;

import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.StateSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;
import arcomat.tree.ClassDiagram;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.List;

/**
 * Looks whether a {@link Law} is broken. A check implements the interfaces of the things that it
 * wants to see; one walk over the workspace shows each thing to the checks that asked for its kind,
 * once and where it is declared, not where it is inherited. A check has no state: what it needs to
 * know beyond the thing is in the context.
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

    interface OnState extends Check {
        void check(StateSymbol state, Context context, Findings findings);
    }

    /** Called once for a clause, however many states it names. */
    interface OnInitial extends Check {
        void check(AutomatonElement.Initial initial, Context context, Findings findings);
    }

    interface OnTransition extends Check {
        void check(TransitionSymbol transition, Context context, Findings findings);
    }

    /**
     * Called for the blocks of transitions and initial states; the context knows the side. Calls
     * and increments are in the block, but are shown as no item.
     */
    interface OnBlock extends Check {
        void check(Block block, Context context, Findings findings);
    }

    interface OnItem extends Check {
        void check(ItemSymbol item, Context context, Findings findings);
    }

    interface OnTable extends Check {
        void check(TableSymbol table, Context context, Findings findings);
    }

    /** Called for the cells of tables that have a column; the context knows the side. */
    interface OnCell extends Check {
        void check(ItemValue cell, TableSymbol.Column column, Context context, Findings findings);
    }

    /**
     * Called for every expression as a whole, with the problems of its parts: guards, item values,
     * cells, initial values, arguments, messages of tests.
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
}
