package arcomat.symbols.occurrences;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.tree.Name;

import java.util.List;
import java.util.Optional;

/** Names in a suite of stream tests. */
record SuitePlaces(NamePlaces places, ExpressionPlaces expressions) {

    void in(TestSuiteSymbol suite) {
        places.declared(suite.node().name().span(), new Referent.Suite(suite));
        suite.component()
                .found()
                .ifPresent(
                        component ->
                                places.path(
                                        suite.node().component().parts(),
                                        new Referent.Component(component.signature())));
        expressions.arguments(suite.arguments());
        new FeaturePlaces(places, Optional.empty())
                .arguments(suite.node().arguments(), suite.named());
        for (VariableSymbol field : suite.fields()) {
            places.declared(field.nameSpan(), new Referent.Variable(field));
            field.initial().ifPresent(expressions::in);
        }
        for (StreamTestSymbol test : suite.tests()) {
            places.declared(test.node().name().span(), new Referent.Test(test));
            test.streams().forEach(stream -> stream(suite, stream));
        }
    }

    private void stream(TestSuiteSymbol suite, StreamSymbol stream) {
        List<Name> path = stream.node().port().parts();
        Optional<ComponentSymbol> current = suite.component().found();
        for (Name name : path.subList(0, path.size() - 1)) {
            Optional<InstanceSymbol> part = current.flatMap(whole -> whole.instance(name.text()));
            part.ifPresent(found -> places.add(name.span(), new Referent.Part(found), Role.REFERS));
            current = part.flatMap(InstanceSymbol::component);
        }
        Role role = stream.isDriven() ? Role.WRITES : Role.READS;
        stream.port()
                .found()
                .ifPresent(
                        port ->
                                places.add(
                                        stream.node().port().last().span(),
                                        new Referent.Port(port),
                                        role));
        expressions.in(stream.messages());
    }
}
