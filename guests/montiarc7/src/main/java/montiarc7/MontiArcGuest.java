package montiarc7;

import arcomat.guest.Guest;
import arcomat.guest.Importer;

import java.util.List;

/** Brings the importer of MontiArc 7. */
public final class MontiArcGuest implements Guest {
    @Override
    public int api() {
        return API;
    }

    @Override
    public String name() {
        return "montiarc7";
    }

    @Override
    public List<Importer> importers() {
        return List.of(new MontiArcImporter());
    }
}
