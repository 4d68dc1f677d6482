package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.source.ComposedForm;
import arcomat.tree.Unit;

/** ARC0207: a file is named after what it defines, so that it can be found. */
public final class ComponentNameIsFileName implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        String file = fileName(unit.file().path());
        int dot = file.lastIndexOf('.');
        String expected = dot < 0 ? file : file.substring(0, dot);
        Definitions.name(unit.definition())
                .filter(name -> !name.text().equals(ComposedForm.of(expected)))
                .ifPresent(
                        name ->
                                findings.report(
                                        name,
                                        "'%s' stands in the file '%s'; rename the file to '%s%s' or"
                                                + " this to '%s'",
                                        name,
                                        file,
                                        name,
                                        dot < 0 ? "" : file.substring(dot),
                                        expected));
    }

    private static String fileName(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }
}
