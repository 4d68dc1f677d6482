package   robot.fig6 ;
import robot.Types.*;
import robot.Other;
/**
    * Keeps its distance.
   */
<<layer="logic">>component AvoidCrash(Integer patience=3) refines robot.fig5.AvoidCrash,robot.fig3.AvoidCrash{
  port in Distance frontUS, // what is ahead
       in TimerSignal timerSig, in LineStatus ls, <<total>> in Boolean gotCoffee, out MotorCmd cmd, out TimerCmd timerCmd;


  timing causalsync;
  automaton{ // six states
    variable Integer[0..10] n=0;
    state driving,backing,remote,returning,waiting,
       lost;
    initial driving/{cmd=fwd};

    // t0: make room
    driving->backing [n<patience&&!(gotCoffee==true)||n>= - 3*( -n)]{frontUS==tooClose,gotCoffee==false}/{cmd=backRight,timerCmd=delay,n=n+1};
    driving->waiting{frontUS==tooClose,gotCoffee==true}/{cmd=stop}; // t1

    /* t2 */ waiting->driving {frontUS==alt{clear,far}}/{cmd=[fwd , fwd]};
    backing -> remote
      // the timer rings
      {timerSig==alert}/{cmd=stop};
    returning {ls=--,frontUS=?} ;
    // nothing more
  }
}
// end
