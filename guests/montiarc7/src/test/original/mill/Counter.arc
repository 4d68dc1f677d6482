package mill;
import mill.Post.*;

/** Looks at parcels. */
component Counter {
  port sync in Express parcel, sync in int most;
  port sync out boolean heavy, near, sync out int rest, sync out Label label;

  automaton {
    initial state Open;

    Open -> Open [parcel.weight > most && parcel.label.speed == Speed.FAST] / {
      heavy = true;
      rest = parcel.hours - 1;
      Log.info(parcel.weight, parcel.label.town, most, Speed.FAST, "heavy");
    }
    Open -> Open [parcel.weight <= most] / {
      Label now = parcel.label;
      near = now.town.equals("Aachen") && parcel.hours < 3;
      label = parcel.label;
    }
  }
}
