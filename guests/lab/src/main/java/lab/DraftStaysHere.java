package lab;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;

/** LAB0003: what is called a draft does not go on a brick. */
final class DraftStaysHere implements Check.OnComponent {
    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        boolean goesOut =
                component.stereotypes().stream()
                        .anyMatch(each -> each.name().text().equals("deploy"));
        if (goesOut && component.name().contains("Draft")) {
            findings.report(
                    component.nameSpan(),
                    "'%s' is a draft and is to go on a brick; finish it, and take the word out of"
                            + " its name",
                    component.name());
        }
    }
}
