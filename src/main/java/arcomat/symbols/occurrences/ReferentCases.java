package arcomat.symbols.occurrences;

/**
 * One answer for each form of what a name stands for.
 *
 * @param <R> what is answered
 */
public interface ReferentCases<R> {
    R packageName(Referent.PackageName name);

    R component(Referent.Component component);

    R diagram(Referent.Diagram diagram);

    R type(Referent.Type type);

    R builtin(Referent.Builtin type);

    R typeParameter(Referent.TypeParameter parameter);

    R constant(Referent.Constant constant);

    R attribute(Referent.Attribute attribute);

    R port(Referent.Port port);

    R part(Referent.Part part);

    R variable(Referent.Variable variable);

    R array(Referent.Array array);

    R bound(Referent.Bound bound);

    R parameter(Referent.Parameter parameter);

    R feature(Referent.Feature feature);

    R state(Referent.State state);

    R behaviour(Referent.Behaviour behaviour);

    R invariant(Referent.Invariant invariant);

    R suite(Referent.Suite suite);

    R test(Referent.Test test);
}
