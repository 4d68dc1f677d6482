package arcomat.check.behaviour.item;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.Typed;
import arcomat.tree.Block;

/** ARC0336: a cell of a table has the type of its column and a form that its side allows. */
public final class TableCellFits implements Check.OnCell {

    @Override
    public void check(
            ItemValue cell, TableSymbol.Column column, Context context, Findings findings) {
        String complaint = complaintAboutForm(cell, column.input());
        if (!complaint.isEmpty()) {
            findings.report(cell.node(), complaint);
        } else {
            checkTypes(cell, column, findings);
        }
    }

    private static String complaintAboutForm(ItemValue cell, boolean input) {
        boolean sequence =
                Items.parts(cell).stream()
                        .anyMatch(part -> part instanceof ItemValue.Sequence s && isLong(s));
        if (sequence) {
            return "a cell is about one message; write a single one";
        }
        if (!input && cell instanceof ItemValue.Alternatives) {
            return "an output cell sends one message; 'alt' is for input cells";
        }
        if (!input && cell.node() instanceof Block.DontCare) {
            return "'*' is for input cells; write the message that is sent, or '--' for none";
        }
        return "";
    }

    private static boolean isLong(ItemValue.Sequence sequence) {
        return sequence.expressions().size() > 1;
    }

    private static void checkTypes(ItemValue cell, TableSymbol.Column column, Findings findings) {
        for (Typed typed : cell.expressions()) {
            if (!typed.isAssignableTo(column.type())) {
                findings.report(
                        typed.expression().node(),
                        "column '%s' takes %s",
                        column.node(),
                        Wording.mismatch(column.type(), typed));
            }
        }
    }
}
