package arcomat.check.language;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;

/**
 * What languages have found wrong with behaviours, under one code.
 *
 * @param name of the law, as of a class
 */
public record ToldByLanguage(String name, String code) implements Check.OnComponent {
    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        component.readings().values().stream()
                .flatMap(each -> each.problems().stream())
                .filter(each -> each.code().equals(code))
                .forEach(each -> findings.give(each.error()));
    }
}
