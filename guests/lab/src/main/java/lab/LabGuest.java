package lab;

import arcomat.check.law.Law;
import arcomat.guest.Guest;

import java.util.List;

/** The naming rules of our laboratory. */
public final class LabGuest implements Guest {
    @Override
    public int api() {
        return API;
    }

    @Override
    public String name() {
        return "lab";
    }

    @Override
    public List<Law> laws() {
        return List.of(
                Law.warning("LAB0001", new PortSaysWhatIs()),
                Law.warning("LAB0002", new StateSaysHowItIs()),
                Law.executableError("LAB0003", new DraftStaysHere()));
    }
}
