use strict;
use Time::HiRes qw(clock_gettime usleep CLOCK_MONOTONIC CLOCK_PROCESS_CPUTIME_ID);

my ($kind, $first) = ($ARGV[0], 1);
$| = 1;

sub burn {
    my ($seconds, $clock, $garbage) = @_;
    my $end = clock_gettime($clock) + $seconds;
    while (clock_gettime($clock) < $end) {
        my @all = $garbage ? map { { k => $_ } } 1 .. 500 : ();
        my $sum = 0;
        $sum += 1 / $_ for 1 .. 500;
    }
}

sub turn {
    if ($kind eq 'clock') {
        burn(0.045, CLOCK_MONOTONIC);
    } elsif ($kind eq 'work') {
        burn(0.045, CLOCK_PROCESS_CPUTIME_ID);
    } elsif ($kind eq 'sleep') {
        usleep(45000);
    } elsif ($kind eq 'read') {
        open(my $file, '<', 'big.txt') or die;
        local $/;
        my @all = split(/7/, <$file>);
    } elsif ($kind eq 'start' && $first) {
        usleep(300000);
        burn(0.3, CLOCK_PROCESS_CPUTIME_ID);
    } elsif ($kind eq 'threads') {
        my @all = map { my $child = fork(); if (!$child) { burn(0.01, CLOCK_PROCESS_CPUTIME_ID); exit(0); } $child } 1 .. 4;
        waitpid($_, 0) for @all;
    } elsif ($kind eq 'garbage') {
        burn(0.03, CLOCK_PROCESS_CPUTIME_ID, 1);
    }
}

while (my $line = <STDIN>) {
    if ($line =~ /^\{"type":"turn"/) {
        turn();
        $first = 0;
        print "{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}\n";
    }
}
