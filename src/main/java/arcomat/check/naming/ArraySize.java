package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Variable;

import java.math.BigInteger;
import java.util.List;
import java.util.stream.Stream;

/**
 * ARC0217: an array has some elements, and not too many. The first one stands for the whole, whose
 * size is written where it is declared.
 */
public final class ArraySize implements Check.OnComponent, Check.OnAutomaton, Check.OnActions {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        component.node().elements(Element.Ports.class).stream()
                .flatMap(each -> each.ports().stream())
                .flatMap(port -> port.names().stream())
                .forEach(name -> check(name.text(), name.span(), findings));
        component.node().elements(Element.Subcomponent.class).stream()
                .flatMap(each -> each.instances().stream())
                .map(Element.Instance::name)
                .forEach(name -> check(name.text(), name.span(), findings));
        variables(
                component.node().elements(Element.Variables.class).stream()
                        .map(Element.Variables::variables),
                findings);
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        variables(
                automaton.node().elements(AutomatonElement.Declaration.class).stream()
                        .map(AutomatonElement.Declaration::variables),
                findings);
    }

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        actions.declarations().stream()
                .flatMap(each -> each.locals().stream())
                .map(ActionSymbol.Local::variable)
                .forEach(local -> check(local.name(), local.nameSpan(), findings));
    }

    private static void variables(Stream<List<Variable>> declared, Findings findings) {
        declared.flatMap(List::stream)
                .map(Variable::name)
                .forEach((Name name) -> check(name.text(), name.span(), findings));
    }

    private static void check(String name, Span place, Findings findings) {
        if (!name.endsWith("[0]")) {
            return;
        }
        String array = name.substring(0, name.length() - "[0]".length());
        String written = ArrayNames.writtenSize(place);
        BigInteger size = new BigInteger(digits(written), radix(written));
        if (size.signum() == 0) {
            findings.report(place, "array '%s' has no element; write how many there are", array);
        } else if (size.compareTo(BigInteger.valueOf(ArrayNames.MOST)) > 0) {
            findings.report(
                    place,
                    "array '%s' has %s elements, more than %s; divide it",
                    array,
                    size,
                    ArrayNames.MOST);
        }
    }

    private static String digits(String number) {
        return number.replaceFirst("^0[xXbB]", "").replace("_", "");
    }

    private static int radix(String number) {
        if (number.length() < 2) {
            return 10;
        }
        return switch (number.charAt(1)) {
            case 'x', 'X' -> 16;
            case 'b', 'B' -> 2;
            default -> 10;
        };
    }
}
