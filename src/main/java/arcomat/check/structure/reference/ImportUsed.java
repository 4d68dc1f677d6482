package arcomat.check.structure.reference;

import arcomat.check.facts.Deletion;
import arcomat.check.law.Check;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit.Import;

import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** ARC0123: something in the file needs the import. (Hab16 CV4) */
public final class ImportUsed implements Check.OnNames {

    @Override
    public void check(List<QualifiedName> names, Context context, Findings findings) {
        Map<String, QualifiedName> distinct = new LinkedHashMap<>();
        for (QualifiedName name : names) {
            distinct.putIfAbsent(name.text(), name);
        }
        Set<String> used = used(distinct.values(), context);
        for (Import each : context.unit().imports()) {
            boolean leadsSomewhere = context.scope().target(each).isFound();
            if (leadsSomewhere
                    && !(context.scope().mayLeadFurther(each) && isOpen(distinct.values(), context))
                    && !used.contains(text(each))
                    && !isAmbiguous(distinct.values(), context)) {
                String name = text(each);
                findings.report(each, "nothing in this file needs '%s'; delete the import", name)
                        .fix(Deletion.ofLine("Delete the import", each));
            }
        }
    }

    private static Set<String> used(Collection<QualifiedName> names, Context context) {
        Set<String> used = new HashSet<>();
        for (QualifiedName name : names) {
            context.scope().importOf(name).ifPresent(each -> used.add(text(each)));
            if (used.size() == context.unit().imports().size()) {
                break;
            }
        }
        return used;
    }

    /** Then several imports explain one name, which is another finding. */
    private static boolean isAmbiguous(Collection<QualifiedName> names, Context context) {
        return names.stream()
                .anyMatch(
                        name ->
                                context.scope().type(name).isAmbiguous()
                                        || context.scope().component(name).isAmbiguous());
    }

    /** Whether the file uses something that another one should define, which did not parse. */
    private static boolean isOpen(Collection<QualifiedName> names, Context context) {
        return names.stream().anyMatch(name -> context.scope().type(name).isExcused());
    }

    /** What an import names, as written. */
    static String text(Import each) {
        return each.name().text() + (each.wildcard() ? ".*" : "");
    }
}
