package arcomat.check;

import arcomat.symbols.Workspace;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.IoTable;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;
import arcomat.tree.TestSuite;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;
import arcomat.tree.Variable;

import java.util.List;

/**
 * A context condition. A check implements the interfaces of the nodes that it wants to see; one
 * walk over the workspace, in text order, shows each node to the checks that asked for its kind. A
 * check has no state: what it needs to know beyond the node is in the context or in the symbols.
 */
interface Check {

    Law law();

    /** Called once, for laws about files or about the network of all components. */
    interface OnWorkspace extends Check {
        void check(Workspace workspace, Findings findings);
    }

    interface OnUnit extends Check {
        void check(Unit unit, Context context, Findings findings);
    }

    /** Called for top-level and inner components; the context's component is the visited one. */
    interface OnComponent extends Check {
        void check(Component component, Context context, Findings findings);
    }

    interface OnPort extends Check {
        void check(Element.Port port, Context context, Findings findings);
    }

    interface OnSubcomponent extends Check {
        void check(Element.Subcomponent subcomponent, Context context, Findings findings);
    }

    interface OnAutomaton extends Check {
        void check(Automaton automaton, Context context, Findings findings);
    }

    interface OnState extends Check {
        void check(AutomatonElement.State state, Context context, Findings findings);
    }

    interface OnInitial extends Check {
        void check(AutomatonElement.Initial initial, Context context, Findings findings);
    }

    interface OnTransition extends Check {
        void check(AutomatonElement.Transition transition, Context context, Findings findings);
    }

    /** Called for the blocks of transitions and initial states; the context knows the side. */
    interface OnBlock extends Check {
        void check(Block block, Context context, Findings findings);
    }

    interface OnTable extends Check {
        void check(IoTable table, Context context, Findings findings);
    }

    /** Called for every expression and every part of it, the whole before its parts. */
    interface OnExpression extends Check {
        void check(Expression expression, Context context, Findings findings);
    }

    /** Called for every type as written, type arguments included. */
    interface OnType extends Check {
        void check(TypeReference type, Context context, Findings findings);
    }

    /** Called for variables of components and automata, and for the fields of test suites. */
    interface OnVariable extends Check {
        void check(Variable variable, TypeReference type, Context context, Findings findings);
    }

    /** Called for every node that can carry stereotypes and does. */
    interface OnStereotypes extends Check {
        void check(
                List<Stereotype> stereotypes,
                Carrier carrier,
                Node owner,
                Context context,
                Findings findings);
    }

    interface OnClassDiagram extends Check {
        void check(ClassDiagram diagram, Context context, Findings findings);
    }

    interface OnTestSuite extends Check {
        void check(TestSuite suite, Context context, Findings findings);
    }
}
