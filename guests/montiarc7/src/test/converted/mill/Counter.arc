package mill;

import mill.Post.Express;
import mill.Post.Label;
import mill.Post.Speed;

/** Looks at parcels. */
component Counter {
    timing instant;
    port in Express parcel, in Integer most;
    port out Boolean heavy, out Boolean near, out Integer rest, out Label label;
    <<completion = "ignore">> automaton {
        state Open;
        initial Open;
        Open -> Open [parcel.weight > most && parcel.label.speed == Speed.FAST] / do {
            heavy = true;
            rest = parcel.hours - 1;
        };
        Open -> Open [parcel.weight <= most] / do {
            Label now = parcel.label;
            near = (now.town == "Aachen") && parcel.hours < 3;
            label = parcel.label;
        };
    }
}
